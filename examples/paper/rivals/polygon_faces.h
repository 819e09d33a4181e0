// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/polygons.h"

#include <functional>
#include <span>

namespace polydec::paper {

/// The corners of one face in R^3, a row each, in their order around it.
using Polygon = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// Throws InvalidInput, naming face or vertex, unless the mesh is a surface in R^3 on which
/// a polygon Laplacian makes sense: numbers in range, three or more corners to a face, no corner
/// twice in a row, finite coordinates, every vertex in some face, and area vectors above 1e-12
/// times the longest edge squared.
void check_surface(const PolygonMesh& mesh);

/// The vertex numbers around face f.
std::span<const Index> corners(const PolygonMesh& mesh, Index f);
Index count_faces(const PolygonMesh& mesh);
Polygon positions(const PolygonMesh& mesh, Index f);

/// Half the sum of x_i cross x_(i+1): normal to the plane of largest projection, as long as the
/// area of that. Source: Alexa and Wardetzky 2011.
Eigen::Vector3d area_vector(const Polygon& polygon);

/// E: row i is x_(i+1) - x_i.
Polygon edges(const Polygon& polygon);
/// B: row i is (x_i + x_(i+1)) / 2, seen from the mean of the corners.
Polygon midpoints(const Polygon& polygon);
/// D: takes values at n corners to the differences along the n edges.
DenseMatrix differences(Index n);

/// Adds up matrices of faces, of the size of their corners, to one of the size of the vertices.
SparseMatrix assemble(const PolygonMesh& mesh,
                      const std::function<DenseMatrix(const Polygon&)>& local);

/// Diagonal: each face gives every corner an equal share of the length of its area vector.
SparseMatrix equal_shares(const PolygonMesh& mesh);

} // namespace polydec::paper
