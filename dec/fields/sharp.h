// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/forms/cochain.h"

namespace polydec {

/// Vectors at the vertices of a primal 1-form a: the mean, weighted by the parts |*v part in t| of
/// the dual cell of v, of sum over w in t of a(v->w) grad lambda_w. For a = df that sum is the
/// gradient on simplex t. One row per vertex, N columns; units: values over length. a is lifted to
/// the simplices; after flips, to the simplices of the input. Exact for constant fields on flat
/// meshes.
/// Throws InvalidInput for other forms and, naming vertices, if dual volumes are zero. Source:
/// Hirani 2003, Def. 5.7.1 and 5.8.1.
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
/// Throws InvalidInput for other forms, and, naming the cell, if its weights do not determine X.
DenseMatrix sharp_pd(const Discretization& mesh, const Cochain& form);

/// Vectors at the merged n-cells of the field X whose fluxes i_X vol are the primal (n-1)-form w:
/// 1/|P| sum over the facets f of [P : f] w(f) (centroid of f - centroid of P), where vol has the
/// orientation of the cell. One row per n-cell, N columns; units: values over length^(n-1). Exact
/// for constant fields on every flat cell. After flips centroids lie on the surface, and the
/// vectors are of first order on smooth surfaces.
/// Source: Perot 2000. Throws InvalidInput for other forms.
DenseMatrix flux_sharp(const Discretization& mesh, const Cochain& form);

} // namespace polydec
