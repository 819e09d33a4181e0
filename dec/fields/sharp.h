// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/forms/cochain.h"

namespace polydec {

/// Vectors at the vertices of a primal 1-form a: the mean, by the parts |*v part in t| of the dual
/// cell of v, of sum over w in t of a(v->w) grad lambda_w, which is the gradient on simplex t if
/// a = df. One row per vertex; N columns; units those of the values over length. a is lifted to the
/// simplices. Constant fields are exact on flat meshes. Source: Hirani 2003, Def. 5.7.1 and 5.8.1.
/// After flips it is that on the simplices of the input.
/// Throws InvalidInput for other forms and, naming vertices, where dual volumes
/// are zero.
DenseMatrix sharp_pp(const Discretization& mesh, const Cochain& form);

/// Vectors at the merged n-cells of a primal 1-form a: X such that X . e = a(e) for the cell's
/// edges, in least squares weighted by |*e part in P| / |e|. It lies in the cell's mean tangent
/// space. One row per n-cell, N columns; units those of the values over length. Attach them to
/// cell_centroids, where they are of second order on regular cells.
/// After flips edges go straight from one end to the other, so X . e is the integral of X along e;
/// where all ends in a cell lie on a line, X does too. Of first order on smooth surfaces.
///
/// Exact for differentials of linear functions on flat cells of any shape. For n = 2 and a = df it
/// is the mean by area of the gradients on the triangles where these lie in one plane and are
/// exactly cospherical; on bent cells it is near to that. In higher dimensions obtuse cells have
/// negative weights; X is then where the derivative of the sum of squares vanishes.
/// Throws InvalidInput for other forms, and, naming the cell, if its weights leave X
/// undetermined.
DenseMatrix sharp_pd(const Discretization& mesh, const Cochain& form);

/// Vectors at the merged n-cells of the field X whose fluxes i_X vol a primal (n-1)-form w holds:
/// 1/|P| sum over the facets f of [P : f] w(f) (centroid of f - centroid of P), vol having the
/// orientation of the cell. One row per n-cell, N columns; units those of the values over
/// length^(n-1). Exact for constant fields on every flat cell. After flips centroids are places on
/// the surface, and the vectors of first order on smooth ones.
/// Source: Perot 2000. Throws InvalidInput for other forms.
DenseMatrix flux_sharp(const Discretization& mesh, const Cochain& form);

} // namespace polydec
