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
/// narrower. Vertices and edges of the boundary keep their numbers and conditions. Returns other
/// shapes unchanged: those of another dimension than 2, with branching edges, or with nonuniform
/// weights. Throws like intrinsic_delaunay.
FlippedShape flipped(const Shape& shape);

} // namespace polydec
