// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/forms/cochain.h"

namespace polydec {

/// The flats: from vector fields to 1-forms. The first letter says where the vectors are: p at
/// vertices, d at merged n-cells. The second says how they are continued: p linearly on simplices
/// (from vertices) or as a constant on each n-cell (from n-cells), d as a constant on each dual
/// cell. The last says where the 1-form lives: p on edges, d on the dual edges, those of the
/// (n-1)-cells.
enum class Flat {
    ppp, ///< (X_v + X_w) / 2 . e: the circulation along e of the linear field
    pdp, ///< X_v . e/2 + X_w . e/2, half of the edge in each dual cell: the same value
    dpp, ///< sum over the n-cells around e of |*e part| / |*e| times X_t . e
    ppd, ///< the circulation of the linear field along the dual edge, a straight piece in each cell
    pdd, ///< the mean of X over the vertices of the facet, times the dual edge
    dpd, ///< sum over the two n-cells of X_t times the piece of the dual edge in t
};

/// The 1-form of a vector field on merged cells: a primal one on the edges or a dual one on the
/// (n-1)-cells. Units those of the field times length. `field` has N columns and a row per vertex
/// or per merged n-cell. Each of them gives the exact integrals of constant fields; ppp and ppd
/// those of linear fields too.
///
/// All is computed on the simplices, over which a merged cell's vector is copied, and mapped to
/// merged cells by sums (primal) or means by volume (dual). The dual edge of a boundary facet ends
/// at the facet's circumcenter. Source: Hirani 2003, ch. 5.
/// Where the star of (n-1)-cells knows no duals (see ChosenStars::is_over_duals) dual forms are the
/// stars of the fluxes through the facets, of the mean of their vertices' vectors or of those of
/// the cells beside them, by volume.
/// After flips ppp and pdp go by the edges of the input and the passage. For dpp an edge goes from
/// its one end to the other, which is all that the integral of a constant depends on; dual edges
/// are straight between the centers of cell_centers, where ppd has the field that is linear on the
/// input's simplices. All is exact as before; of smooth fields on smooth surfaces ppp and ppd are
/// of second order, the others of first at least. Throws InvalidInput for a field of another shape,
/// naming the row if it is not finite; for dpp also, naming the vertices, for edges whose dual
/// volume is zero (HodgeStar::zeros of degree 1).
Cochain flat(const Discretization& mesh, Flat kind, const DenseMatrix& field);

} // namespace polydec
