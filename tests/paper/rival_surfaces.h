// SPDX-License-Identifier: MIT
#pragma once

#include "examples/paper/rivals/polygon_laplacian.h"
#include "tests/support/test.h"

namespace polydec::paper {

using Laplacian = std::function<PolygonLaplacian(const PolygonMesh&)>;

/// The four, with their default parameters, by name.
const std::map<std::string, Laplacian>& rivals();

/// The twin of several laws: every edge of a face has weight 1/2, every vertex mass 1. It knows
/// neither angles nor areas.
PolygonLaplacian of_graph(const PolygonMesh& mesh);

/// The merged cells of a surface, in R^3.
PolygonMesh polygons(const Mesh& mesh);

struct Surface {
    PolygonMesh mesh;
    bool planar = false;  ///< in the plane z = 0
    bool faceted = false; ///< every face is planar
};

/// What the laws are checked on: flat and curved, closed and bounded, convex and not, faces planar
/// and not, one not orientable.
const std::map<std::string, Surface>& surfaces();

inline Vector ones(const SparseMatrix& A) {
    return Vector::Ones(A.rows());
}

} // namespace polydec::paper
