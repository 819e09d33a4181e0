// SPDX-License-Identifier: MIT
#pragma once

#include "io/pages/page_faces.h"

#include <string>

namespace polydec {

/// An SVG picture of cells for browsers without WebGL: the surface of solids, coarse above some
/// thousand polygons. `shown` is an array on the points or the top cells that gives the colors, or
/// null. The grid has the points and the top cells. The axis `up` points upwards in space.
std::string still_picture(const VtuGrid& grid, const PageFaces& faces, const VtuArray* shown,
                          int up);

} // namespace polydec
