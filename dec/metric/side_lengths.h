// SPDX-License-Identifier: MIT
#pragma once

#include "complex/surfaces/glued_surface.h"

#include <array>

namespace polydec {

/// Throws InvalidInput, naming the edge or triangle, unless there is one positive length for each
/// edge and every triangle has some area with them.
void check_lengths(const Triangles& surface, const Vector& lengths);

/// The side lengths of a triangle, those of its three half-edges.
std::array<double, 3> side_lengths(const Triangles& surface, const Vector& lengths, Index triangle);

} // namespace polydec
