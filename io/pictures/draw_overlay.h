// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "io/pictures/vtu.h"

namespace polydec {

/// The input's triangles cut along the edges that intrinsic flips have made, as polygons; of each
/// piece the array `cell` holds the merged cell, `triangle` the triangle of the input, numbered as
/// in the complex. Points are the vertices, then where edges cross. Throws like overlay and
/// check_drawable.
VtuGrid draw_overlay(const Discretization& discretization);

/// The merged cells of largest dimension, with their tags as the array `tag` where there are any;
/// after intrinsic flips draw_overlay's pieces, each with the tag of its cell. Throws like both.
VtuGrid draw_mesh(const Discretization& discretization);

} // namespace polydec
