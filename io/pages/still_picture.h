// SPDX-License-Identifier: MIT
#pragma once

#include "io/pages/page_faces.h"

#include <string>

namespace polydec {

/// An SVG picture of cells for who has no WebGL: of the surface of solids, and coarse where there
/// are more than some thousand polygons. `shown` is an array of the points or of the top cells, by
/// which they are painted, or null. The grid has the points, and the top cells.
std::string still_picture(const VtuGrid& grid, const PageFaces& faces, const VtuArray* shown);

} // namespace polydec
