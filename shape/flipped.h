// SPDX-License-Identifier: MIT
#pragma once

#include "shape/shape.h"

namespace polydec {

/// A shape, and how many edges were flipped to make its triangles Delaunay.
struct FlippedShape {
    Shape shape;
    Index flips = 0;
};

/// The same surface by its intrinsic Delaunay triangulation, whose small angles make enclosures of
/// eigenvalues narrow: vertices and edges of the boundary keep their numbers, and conditions hold.
/// What has nothing to flip is returned as it is: shapes of another dimension than 2, or with
/// branching edges, and weights that are not the same everywhere. Throws like intrinsic_delaunay.
FlippedShape flipped(const Shape& shape);

} // namespace polydec
