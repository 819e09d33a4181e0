// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization/discretization.h"
#include "dec/metric/simplex_faces.h"

#include <string_view>

namespace polydec {

/// The oriented edges of an n-piece where the piece lies, in the order of `edges`, its 1-faces: at
/// a seam an edge has a place and a direction on each side.
DenseMatrix edges_beside(const Discretization& mesh, SimplexFaces& edges, Index piece);

/// Throw InvalidInput, naming vertices, if seams turn, so that the two sides of a facet see a
/// vector in different directions: for vectors at vertices; for vectors of merged n-cells only if
/// such a facet lies inside a cell. `what` names the function. Linear time on glued meshes.
void refuse_turned_vertices(const Discretization& mesh, std::string_view what);
void refuse_turned_cells(const Discretization& mesh, std::string_view what);

} // namespace polydec
