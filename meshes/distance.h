// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

namespace polydec {

/// How far apart two points are, also where the squares of that would overflow or vanish: 0 for
/// equal points alone. Throws InvalidInput, naming both, if it is no finite number.
double distance(const Points& points, Index a, Index b);

} // namespace polydec
