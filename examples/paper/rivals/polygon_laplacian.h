// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

namespace polydec::paper {

/// A Laplacian of functions at the vertices of a polygonal surface, in weak form:
/// Delta = mass^-1 stiffness = -div grad. Both are symmetric, with one row per vertex.
struct PolygonLaplacian {
    SparseMatrix stiffness; ///< positive semidefinite, constants in the kernel; no units
    SparseMatrix mass;      ///< positive definite; entries sum to the area; units length^2
};

} // namespace polydec::paper
