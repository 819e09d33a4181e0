// SPDX-License-Identifier: MIT
#pragma once

#include "shape/shape.h"

#include <vector>

namespace polydec {

/// The same surface with these triangles bisected twice at the midpoints of longest edges, and
/// neighbors bisected as far as conformity requires. Angles stay above half of the smallest initial
/// angle. Vertices keep their numbers; new ones follow. Edges and triangles inherit conditions and
/// weights. Branching edges and edges glued to themselves are allowed. Uses lengths alone: the
/// median of a triangle is l^2 = (2 b^2 + 2 c^2 - a^2) / 4. Source: Rivara 1984. Throws
/// InvalidInput for dimensions other than 2.
Shape bisected(const Shape& shape, const std::vector<Index>& triangles);

} // namespace polydec
