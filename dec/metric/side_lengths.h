// SPDX-License-Identifier: MIT
#pragma once

#include "complex/surfaces/glued_surface.h"

#include <array>

namespace polydec {

/// Throws InvalidInput, naming the edge or triangle, unless there is one positive length per edge
/// and every triangle has positive area.
void check_lengths(const Triangles& surface, const Vector& lengths);

/// The lengths of the three half-edges of a triangle.
std::array<double, 3> side_lengths(const Triangles& surface, const Vector& lengths, Index triangle);

} // namespace polydec
