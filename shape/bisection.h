// SPDX-License-Identifier: MIT
#pragma once

#include "shape/shape.h"

#include <vector>

namespace polydec {

/// The same shape, in any dimension n >= 1, with these n-simplices bisected twice at the midpoints
/// of longest edges, and neighbors bisected as far as conformity requires. On surfaces, angles stay
/// above half of the smallest initial angle. Vertices keep their numbers; new ones follow. Facets
/// and simplices inherit conditions and weights. Branching facets and simplices glued to themselves
/// are allowed. Uses lengths alone: the median of a triangle is l^2 = (2 b^2 + 2 c^2 - a^2) / 4.
/// Source: Rivara 1984.
Shape bisected(const Shape& shape, const std::vector<Index>& simplices);

} // namespace polydec
