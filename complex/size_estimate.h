// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

namespace polydec {

/// Size of a simplicial complex, before it is built.
struct SizeEstimate {
    double cells = 0;      ///< of all degrees
    double incidences = 0; ///< of cells of neighboring degrees

    /// Peak memory of the complex, its volumes and its merging together.
    double bytes() const;
};

/// Estimates the size from the dimension n, the number of n-simplices and their number of vertices,
/// in time O(n). Exact for a single simplex and for disjoint simplices. Otherwise a model:
/// simplices that share more vertices share more faces, and facets in pairs. For grids and Delaunay
/// meshes it gives half to all of the cells. Infinite if the numbers overflow.
SizeEstimate estimate_size(int dimension, Index simplices, Index vertices);

} // namespace polydec
