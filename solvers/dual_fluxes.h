// SPDX-License-Identifier: MIT
#pragma once

#include "complex/relative.h"
#include "dec/forms/cells.h"

namespace polydec {

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
void check_two_sided(const Cells& cells);

/// The fluxes of a dual 0-form: |f| over the resistance of f. Facets of the natural boundary
/// conduct nothing; those of Robin's have its coefficient, else 0, and conduct as their half duals
/// in series with 1 over it, to the datum over it. Throws InvalidInput like check_two_sided, and,
/// naming a facet, if an interior resistance is zero.
DualFluxes dual_fluxes(const Cells& cells, const CellMarks& essential, const Vector& robin);

} // namespace polydec
