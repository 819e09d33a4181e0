// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/forms/cochain.h"

namespace polydec {

/// The flats, from vector fields to 1-forms. First letter, where the vectors are: p at vertices, d
/// at merged n-cells. Second letter, how they are continued: p linearly on simplices (from
/// vertices) or as a constant on each n-cell (from n-cells), d as a constant on each dual cell.
/// Third letter, where the 1-form lives: p on edges, d on dual edges, the duals of the (n-1)-cells.
enum class Flat {
    ppp, ///< (X_v + X_w) / 2 . e: the circulation along e of the linear field
    pdp, ///< X_v . e/2 + X_w . e/2, half of the edge in each dual cell: the same value
    dpp, ///< sum over the n-cells around e of |*e part| / |*e| times X_t . e
    ppd, ///< circulation of the linear field along the dual edge, a straight piece in each cell
    pdd, ///< mean of X over the vertices of the facet, times the dual edge
    dpd, ///< sum over the two n-cells of X_t times the piece of the dual edge in t
};

/// The 1-form of a vector field on merged cells: a primal form on the edges or a dual form on the
/// (n-1)-cells. Units: field times length. `field` has N columns and a row per vertex or per merged
/// n-cell. Every kind gives the exact integrals of constant fields; ppp and ppd also of linear
/// fields.
///
/// The flat is computed on the simplices, to which the vector of a merged cell is copied, and
/// mapped to merged cells by sums (primal) or means by volume (dual). The dual edge of a boundary
/// facet ends at the facet's circumcenter. Source: Hirani 2003, ch. 5. If the star of (n-1)-cells
/// knows no duals (see ChosenStars::is_over_duals), a dual form is the star of fluxes through the
/// facets, by the mean vector at a facet's vertices or, for vectors at n-cells, by the mean by
/// volume over the cells beside it.
/// After flips, ppp and pdp use the edges of the input and the passage. For dpp an edge is the
/// segment between its ends: the integral of a constant depends on nothing else. Dual edges are
/// straight between the cell_centers; ppd integrates the field that is linear on the input's
/// simplices. Constants remain exact; for smooth fields on smooth surfaces ppp and ppd are of
/// second order, the others at least of first. Throws InvalidInput for a field of another shape,
/// naming the row if it is not finite; for dpp also, naming the vertices, for edges whose dual
/// volume is zero (HodgeStar::zeros of degree 1).
Cochain flat(const Discretization& mesh, Flat kind, const DenseMatrix& field);

} // namespace polydec
