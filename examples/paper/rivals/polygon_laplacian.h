// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

namespace polydec::paper {

/// A Laplacian of functions at the vertices of a polygonal surface, in weak form:
/// Delta = mass^-1 stiffness = -div grad. Both are symmetric, a row and a column per vertex.
struct PolygonLaplacian {
    SparseMatrix stiffness; ///< positive semidefinite, constants in the kernel; no units
    SparseMatrix mass;      ///< positive definite; entries add up to the area; units length^2
};

} // namespace polydec::paper
