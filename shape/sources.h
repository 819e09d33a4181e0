// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"
#include "complex/surfaces/glued_surface.h"

#include <span>

namespace polydec {

/// Throws InvalidInput for sources that are not vertices of the surface, and, naming a vertex, if a
/// component has no source.
void check_sources(const Triangles& surface, std::span<const Index> sources);

/// Distances of the vertices of unfolded triangles, times 2^exponent. Throws InvalidInput, naming
/// the vertex, for distances that overflow or underflow.
Vector in_units_of_lengths(const Triangles& surface, const Vector& unfolded, int exponent);

} // namespace polydec
