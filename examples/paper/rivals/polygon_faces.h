// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/polygons.h"

#include <functional>

namespace polydec::paper {

/// The corners of one face in R^3, one row each, in order around the face.
using Polygon = Eigen::Matrix<double, Eigen::Dynamic, 3>;

/// Checks that a polygon Laplacian is well defined on a surface in R^3: numbers in range, three or
/// more corners per face, no corner twice in a row, finite coordinates, every vertex in some face,
/// and area vectors above 1e-12 times the longest edge squared. Throws InvalidInput, naming face or
/// vertex.
void check_surface(const PolygonMesh& mesh);

/// The corners of face f.
Polygon positions(const PolygonMesh& mesh, Index f);

/// Half the sum of x_i cross x_(i+1): normal to the plane of largest projection; its length is the
/// area of this projection. Source: Alexa and Wardetzky 2011.
Eigen::Vector3d area_vector(const Polygon& polygon);

/// E: row i is x_(i+1) - x_i.
Polygon edges(const Polygon& polygon);
/// B: row i is (x_i + x_(i+1)) / 2, seen from the mean of the corners.
Polygon midpoints(const Polygon& polygon);
/// D: maps values at n corners to the differences along the n edges.
DenseMatrix differences(Index n);

/// Assembles face matrices, one row per corner, to a matrix with one row per vertex.
SparseMatrix assemble(const PolygonMesh& mesh,
                      const std::function<DenseMatrix(const Polygon&)>& local);

/// Diagonal: each face gives every corner an equal share of the length of its area vector.
SparseMatrix equal_shares(const PolygonMesh& mesh);

} // namespace polydec::paper
