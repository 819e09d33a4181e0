// SPDX-License-Identifier: MIT
#pragma once

#include "complex/components.h"
#include "dec/discretization.h"

namespace polydec {

/// How values of a dual 0-form and boundary values act on each other through the facets.
struct DualFluxes {
    Vector weights;          ///< flux through a facet per difference of the values beside it
    std::vector<bool> fixed; ///< cells whose circumcenter lies on the boundary
    std::vector<bool> tied;  ///< cells beside a boundary facet through which something flows
    SparseMatrix load;       ///< boundary values to right-hand side, cells x facets
    SparseMatrix fix;        ///< boundary values to the values of fixed cells, cells x facets
};

/// The fluxes of a dual 0-form: |f| over the dual length of f, which is divided by the conductivity
/// (kappa of each merged n-cell; empty: 1) where it lies in a cell. Facets of the natural boundary
/// have none. Throws InvalidInput, naming the facets, if the complex is non-orientable or branching
/// an interior dual has no length, or what its parts in two cells resist cancels.
DualFluxes dual_fluxes(const Discretization& discretization, const CellMarks& essential,
                       const Vector& conductivity = {});

} // namespace polydec
