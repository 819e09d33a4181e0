// SPDX-License-Identifier: MIT
#pragma once

#include "base/errors.h"
#include "complex/components.h"
#include "dec/discretization.h"

#include <functional>

namespace polydec {

/// The duals of facets as what flows across them meets them.
struct FacetDuals {
    Vector resistances;                       ///< dual lengths, by the star
    std::vector<bool> missing;                ///< boundary facets whose dual counts as nothing
    std::function<std::string(Index)> named;  ///< a facet in words
    std::function<Error::Place(Index)> place; ///< the same for programs
};

/// Those of any cells; names alone where the star is a matrix.
FacetDuals facet_duals(const CellComplex& complex, const HodgeStars& stars);

/// The same, with the vertices of facets in their names.
FacetDuals facet_duals(const Discretization& mesh);

/// How values of a dual 0-form and boundary values act on each other through the facets.
struct DualFluxes {
    Vector weights;          ///< flux through a facet per difference of the values beside it
    std::vector<bool> fixed; ///< cells whose circumcenter lies on the boundary
    std::vector<bool> tied;  ///< cells beside a boundary facet through which something flows
    SparseMatrix load;       ///< boundary values to right-hand side, cells x facets
    SparseMatrix fix;        ///< boundary values to the values of fixed cells, cells x facets
    SparseMatrix robin_load; ///< data of Robin's condition to right-hand side, cells x facets
};

/// Throws InvalidInput, naming a facet, if the cells are not coherently oriented or branch: dual
/// 0-forms are functions only where every facet separates at most two cells that agree on its
/// sides.
void check_two_sided(const CellComplex& complex, const FacetDuals& duals);

/// The fluxes of a dual 0-form: |f| over the resistance of f. Facets of the natural boundary
/// conduct nothing; those of Robin's have its coefficient, else 0, and conduct as their half duals
/// in series with 1 over it, to the datum over it. Throws InvalidInput like check_two_sided, and,
/// naming a facet, if an interior resistance is zero.
DualFluxes dual_fluxes(const CellComplex& complex, const HodgeStars& stars, const FacetDuals& duals,
                       const CellMarks& essential, const Vector& robin);

} // namespace polydec
