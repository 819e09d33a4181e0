// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/forms/star.h"

#include <string>
#include <vector>

namespace polydec {

/// Where Hodge stars come from. On flat cells inner products of constant forms are exact for
/// galerkin and hybrid ones in every degree, for all others in degrees 0 and n.
enum class StarKind {
    circumcentric, ///< dual over primal volume: diagonal, but not positive on every mesh
    galerkin,      ///< inner products of Whitney forms, on merged cells by the lift: positive
                   ///< definite on every mesh; diagonal for k = n alone
    hybrid,        ///< n = 2: galerkin on the cells beside edges whose dual is not positive and on
                   ///< as many around them as make it definite, circumcentric on all others
    barycentric,   ///< diagonal and positive, duals between centroids. Inconsistent for 0 < k < n:
                   ///< linear functions have no exact fluxes, which need not converge
    automatic, ///< hybrid for n = 2; else circumcentric if every dual is positive; else galerkin
               ///< for 0 < k < n and barycentric for k = 0
};

struct ChosenStars {
    HodgeStars stars;
    StarKind kind; ///< what automatic has become: galerkin with a diagonal star_0 for n > 2
    /// Of each n-cell whether it has Galerkin's stars: then a dual 0-form has its value at the
    /// centroid, else at the circumcenter.
    std::vector<bool> galerkin;

    /// How many of the n-cells these are, 0 to 1.
    double galerkin_share() const;
};

/// The stars of a mesh of some kind, size(k) x size(k), units length^(n-2k). Linear time, but for
/// the lift of merged cells; hybrid ones take a pass more whenever vertices add bad cells.
/// Source: Whitney 1957 for the forms, Hirani 2003 for the diagonal.
/// Throws InvalidInput for hybrid stars in another dimension than 2.
ChosenStars choose_stars(const Discretization& mesh, StarKind kind);

/// "circumcentric", "galerkin" ..
const char* name(StarKind kind);

} // namespace polydec
