// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

namespace polydec {

/// Distance between two points, safe against overflow and underflow of squares: 0 for equal points
/// alone. Throws InvalidInput, naming both points, if it is not finite.
double distance(const Points& points, Index a, Index b);

} // namespace polydec
