// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "io/pictures/vtu.h"
#include "meshes/polygons.h"

namespace polydec {

/// The input's triangles cut along the edges that intrinsic flips have made, as polygons; of each
/// piece the array `cell` holds the merged cell, `triangle` the triangle of the input, numbered as
/// in the complex. Points are those of the input. Throws like overlay and check_drawable.
VtuGrid draw_overlay(const Discretization& discretization);

/// The merged 2-cells of a surface as polygons, at the places of the input; after intrinsic flips
/// those of draw_overlay.
PolygonMesh polygon_mesh(const Discretization& discretization);

} // namespace polydec
