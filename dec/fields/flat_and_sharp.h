// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization/discretization.h"
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
/// facets, without materials (see Cells::geometric_star), by the mean vector at a facet's vertices
/// or, for vectors at n-cells, by the mean by volume over the cells beside it. After flips, ppp and
/// pdp use the edges of the input and the passage. For dpp an edge is the segment between its ends:
/// the integral of a constant depends on nothing else. Dual edges are straight between the
/// cell_centers; ppd integrates the field that is linear on the input's simplices. Constants remain
/// exact; for smooth fields on smooth surfaces ppp and ppd are of second order, the others at least
/// of first. Throws InvalidInput for a field of another shape, naming the row if it is not finite;
/// for fields at vertices if seams of a glued mesh turn, for others if such a seam cuts a merged
/// cell; for dpp also, naming the vertices, for edges whose dual volume is zero (HodgeStar::zeros
/// of degree 1).
Cochain flat(const Discretization& mesh, Flat kind, const DenseMatrix& field);

/// Vectors at the vertices of a primal 1-form a: the mean, weighted by the parts |*v part in t| of
/// the dual cell of v, of sum over w in t of a(v->w) grad lambda_w. For a = df that sum is the
/// gradient on simplex t. One row per vertex, N columns; units: values over length. a is lifted to
/// the simplices; after flips, to the simplices of the input. Exact for constant fields on flat
/// meshes.
/// Throws InvalidInput for other forms, if seams turn and, naming vertices, if dual volumes are
/// zero. Source: Hirani 2003, Def. 5.7.1 and 5.8.1.
DenseMatrix sharp_pp(const Discretization& mesh, const Cochain& form);

/// Vectors at the merged n-cells of a primal 1-form a: the least-squares solution X of X . e = a(e)
/// for the cell's edges, with weights |*e part in P| / |e|. X lies in the cell's mean tangent
/// space. One row per n-cell, N columns; units: values over length. Attach the vectors to
/// cell_centroids, where they are of second order on regular cells.
/// After flips an edge is the segment between its ends, so X . e is the integral of X along it; if
/// all ends in a cell lie on a line, so does X. Of first order on smooth surfaces.
///
/// Exact for differentials of linear functions on flat cells of any shape. For n = 2 and a = df, X
/// is the mean by area of the triangles' gradients if these triangles lie in one plane and are
/// exactly cospherical; on bent cells it is near that mean. In higher dimensions obtuse cells have
/// negative weights; X is then the stationary point of the sum of squares.
/// Throws InvalidInput for other forms, and, naming the cell, if its weights do not determine X or
/// a seam that turns cuts it.
DenseMatrix sharp_pd(const Discretization& mesh, const Cochain& form);

/// Vectors at the merged n-cells of the field X whose fluxes i_X vol are the primal (n-1)-form w:
/// 1/|P| sum over the facets f of [P : f] w(f) (centroid of f - centroid of P), where vol has the
/// orientation of the cell. One row per n-cell, N columns; units: values over length^(n-1). Exact
/// for constant fields on every flat cell. After flips centroids lie on the surface, and the
/// vectors are of first order on smooth surfaces.
/// Source: Perot 2000. Throws InvalidInput for other forms, and for a cell that a seam that turns
/// cuts.
DenseMatrix flux_sharp(const Discretization& mesh, const Cochain& form);

/// What a 1-form on a surface holds of a vector field: circulations along cells, or fluxes through
/// them. In space 1-forms hold circulations and 2-forms fluxes.
enum class Proxy { automatic, flux };

/// Whether a form has proxy vectors: 1-forms and (n-1)-forms for n > 1.
bool has_proxy(const Discretization& mesh, const Cochain& form);

/// Proxy vectors of a form at the merged n-cells: the field whose circulations a 1-form holds, or
/// whose fluxes an (n-1)-form holds, by sharp_pd or flux_sharp; of a dual form after the inverse
/// star without materials (see Cells::geometric_star). Attach them to cell_centroids. One row per
/// n-cell, N columns; units: values over length^degree. No rows without has_proxy. Throws
/// InvalidInput like these functions.
DenseMatrix vectors_at_cells(const Discretization& mesh, const Cochain& form,
                             Proxy proxy = Proxy::automatic);

/// The same at the vertices, one row for each: by sharp_pp for circulations of primal forms on
/// meshes that have it, else means_at_vertices of the vectors at cells.
DenseMatrix vectors_at_vertices(const Discretization& mesh, const Cochain& form,
                                Proxy proxy = Proxy::automatic);

/// Means by volume of vectors at the n-cells around each vertex. Exact for constants. Throws
/// InvalidInput for another number of rows, and if seams turn.
DenseMatrix means_at_vertices(const Discretization& mesh, const DenseMatrix& at_cells);

} // namespace polydec
