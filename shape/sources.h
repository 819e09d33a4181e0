// SPDX-License-Identifier: MIT
#pragma once

#include "complex/surfaces/glued_surface.h"

#include <span>

namespace polydec {

/// Throws InvalidInput for sources that are no vertices of the surface, and, naming a vertex, if a
/// component has none of them.
void check_sources(const Triangles& surface, std::span<const Index> sources);

} // namespace polydec
