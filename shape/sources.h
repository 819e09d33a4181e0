// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"
#include "complex/surfaces/glued_surface.h"

#include <span>

namespace polydec {

/// Throws InvalidInput for sources that are no vertices of the surface, and, naming a vertex, if a
/// component has none of them.
void check_sources(const Triangles& surface, std::span<const Index> sources);

/// Distances of the vertices of unfolded triangles, times 2 to this power. Throws InvalidInput,
/// naming the vertex, for those out of the range of numbers.
Vector in_units_of_lengths(const Triangles& surface, const Vector& unfolded, int exponent);

} // namespace polydec
