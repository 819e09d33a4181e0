// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"

namespace polydec {

/// Circumcenters of the merged k-cells, where dual (n-k)-forms of degree 0 have their values: one
/// row of N coordinates per cell. Over a cell of several pieces, whose circumcenters differ if it
/// is bent, their mean by volume. For k = 0 the vertices themselves.
/// volumes are those of the simplices. Throws InvalidInput where only lengths are known.
Points cell_centers(const Merging& merging, const Points& points, const CellVolumes& volumes,
                    int k);

/// Centroids (centers of mass) of the merged k-cells, the means by volume of those of their pieces:
/// one row of N coordinates per cell. Where vector fields made from forms belong: the mean of a
/// linear function over a cell is its value there. Arguments as above.
Points cell_centroids(const Merging& merging, const Points& points, const CellVolumes& volumes,
                      int k);

/// The same on the cells of a bundle; where only lengths are known, as many rows without
/// coordinates. After intrinsic flips centers are those of the triangles with the same corners,
/// seen through their barycentric coordinates: off a curved surface by the square of their size,
/// and on a flat one.
Points cell_centers(const Discretization& discretization, int k);

} // namespace polydec
