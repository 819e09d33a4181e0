// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "io/pictures/vtu.h"

namespace polydec {

/// The input's triangles cut along the flipped edges, as polygons. For each piece the array `cell`
/// holds the merged cell, `triangle` the input triangle, numbered as in the complex. Points are the
/// vertices, then the crossings of edges. Throws like overlay and check_drawable.
VtuGrid draw_overlay(const Discretization& discretization);

/// The merged cells of largest dimension, with the array `tag` if they have tags; after intrinsic
/// flips the pieces of draw_overlay, each with the tag of its cell. Throws like both.
VtuGrid draw_mesh(const Discretization& discretization);

} // namespace polydec
