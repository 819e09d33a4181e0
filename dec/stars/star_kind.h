// SPDX-License-Identifier: MIT
#pragma once

#include "dec/stars/star.h"

#include <vector>

namespace polydec {

/// Kinds of Hodge stars. On flat cells, inner products of constant forms are exact in every degree
/// for galerkin and hybrid stars, and in degrees 0 and n for all other stars.
enum class StarKind {
    circumcentric, ///< dual over primal volume: diagonal, but not positive on every mesh
    galerkin,      ///< inner products of Whitney forms, on merged cells by the lift: positive
                   ///< definite on every mesh; diagonal only for k = n
    hybrid,        ///< n = 2: galerkin on the cells beside edges whose dual is not positive and on
                   ///< as many around them as make it definite, circumcentric on all others
    barycentric,   ///< diagonal and positive, duals between centroids. Inconsistent for 0 < k < n:
                   ///< linear functions have no exact fluxes, which need not converge
    automatic,     ///< circumcentric if every dual is positive; else hybrid for n = 2, and for all
                   ///< other n galerkin for 0 < k < n and barycentric for k = 0
    own            ///< supplied by the user; cannot be selected
};

/// "circumcentric", "galerkin" ..
const char* name(StarKind kind);

/// Whether no star has a zero or a negative entry.
bool all_positive(const HodgeStars& stars);

/// The kind that automatic selects.
StarKind automatic_kind(int dimension, bool every_dual_is_positive);

struct ChosenStars {
    HodgeStars stars;
    StarKind kind; ///< the kind selected, never automatic
    /// For each n-cell, whether it has Galerkin's stars: then a dual 0-form has its value at the
    /// centroid, else at the circumcenter.
    std::vector<bool> galerkin;

    ChosenStars(const HodgeStars& stars, StarKind kind, std::vector<bool> galerkin);

    /// Without Galerkin cells.
    explicit ChosenStars(const HodgeStars& stars, StarKind kind = StarKind::own);

    /// Whether the star of k-cells uses the circumcentric duals of the volumes, so that dual forms
    /// are integrals over these duals. If not, dual forms are stars of primal forms.
    bool is_over_duals(int k) const;

    /// Fraction of n-cells with Galerkin's stars, 0 to 1.
    double galerkin_share() const;
};

} // namespace polydec
