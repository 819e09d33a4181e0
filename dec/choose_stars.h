// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/forms/star.h"

#include <string>
#include <vector>

namespace polydec {

/// Where Hodge stars come from. All are exact for constant forms on flat meshes, but barycentric
/// ones of degrees 0 < k < n.
enum class StarKind {
    circumcentric, ///< dual over primal volume: diagonal, but not positive on every mesh
    galerkin,      ///< inner products of Whitney forms, on merged cells by the lift: positive
                   ///< definite on every mesh; diagonal for k = n alone
    hybrid,        ///< n = 2: galerkin on the cells beside edges whose dual is not positive and on
                   ///< as many around them as make it definite, circumcentric on all others
    barycentric,   ///< diagonal and positive, duals between centroids. Inconsistent for 0 < k < n:
                   ///< fluxes stay wrong by 20 to 40 % however fine the mesh is
    automatic, ///< hybrid for n = 2; else circumcentric if every dual is positive; else galerkin
               ///< for 0 < k < n and barycentric for k = 0
};

struct ChosenStars {
    HodgeStars stars;
    StarKind kind; ///< what automatic has become
    /// Of each n-cell whether it has Galerkin's stars: then a dual 0-form has its value at the
    /// centroid, else at the circumcenter.
    std::vector<bool> galerkin;

    /// How many of the n-cells these are, 0 to 1.
    double galerkin_share() const;
};

/// The stars of a mesh of some kind. Linear time, but for the lift of merged cells.
/// Throws InvalidInput for hybrid stars in another dimension than 2.
ChosenStars choose_stars(const Discretization& mesh, StarKind kind);

/// "circumcentric", "galerkin" ..
const char* name(StarKind kind);

} // namespace polydec
