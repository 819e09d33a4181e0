// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

namespace polydec {

/// How large a simplicial complex is, before it is built.
struct SizeEstimate {
    double cells = 0;      ///< of all degrees
    double incidences = 0; ///< of cells of neighboring degrees

    /// What the complex, its volumes and its merging take together, at the most at a time.
    double bytes() const;
};

/// From the dimension n, the number of n-simplices and of their vertices, in time O(n). Exact for a
/// single simplex and for simplices that meet nowhere; else a model in which simplices share faces
/// the more, the more they share vertices, and facets in pairs: of grids and Delaunay meshes it
/// gives half to all of the cells. Infinite where the numbers are beyond the doubles.
SizeEstimate estimate_size(int dimension, Index simplices, Index vertices);

} // namespace polydec
