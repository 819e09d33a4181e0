// SPDX-License-Identifier: MIT
#pragma once

#include "shape/shape.h"

#include <vector>

namespace polydec {

/// The same surface with these triangles bisected, each twice, at the middles of longest edges, and
/// others as far as edges must fit. Angles stay above half of the least there was. Vertices keep
/// their numbers, new ones follow; edges and triangles have those of what they are parts of:
/// conditions and weights. Branching edges and edges glued to themselves are as good as others.
/// Works on lengths alone: of the median of a triangle l^2 = (2 b^2 + 2 c^2 - a^2) / 4. Source:
/// Rivara 1984. Throws InvalidInput for another dimension than 2.
Shape bisected(const Shape& shape, const std::vector<Index>& triangles);

} // namespace polydec
