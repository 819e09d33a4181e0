// SPDX-License-Identifier: MIT
#pragma once

#include "shape/shape.h"

namespace polydec {

/// A shape with Delaunay triangles, and the number of edges flipped to make them.
struct FlippedShape {
    Shape shape;
    Index flips = 0;
};

/// The intrinsic Delaunay triangulation of a surface. Its larger angles make eigenvalue enclosures
/// narrower. Vertices and edges of the boundary keep their numbers and conditions. Returns a shape
/// unchanged if its dimension is not 2, edges branch, or weights are not uniform. Throws like
/// intrinsic_delaunay.
FlippedShape flipped(const Shape& shape);

} // namespace polydec
