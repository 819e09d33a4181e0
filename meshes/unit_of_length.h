// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/length_mesh.h"

#include <optional>
#include <string_view>

namespace polydec {

/// The length to measure a mesh in so that products of its lengths are ordinary numbers: 1 where
/// the longest edge (of points, its largest coordinate difference) is between 2^-40 and 2^40 (in
/// more than six dimensions n, 2^-(240/n) and 2^(240/n)), else the power of 4 by which it becomes 1
/// to 8. Vertex numbers must be valid.
double unit_of_length(const Mesh& mesh);
double unit_of_length(const LengthMesh& mesh);

/// The same where a mesh is known in parts: of all of it half the longest edge's largest coordinate
/// difference, and the largest coordinate.
double unit_of_length(double half_of_longest, double farthest, int dimension);

/// Half the largest difference of coordinates between two corners of a simplex.
double half_of_longest_edge(const Points& points, const Simplices& simplices);

/// The mesh with its points divided by a unit, a power of two: exact, but for coordinates that are
/// 2^-1022 units or less.
Mesh in_units(Mesh mesh, double unit);
Points in_units(Points points, double unit);

/// What was measured in units (a power of 4) to some power, a whole number or a half, as the
/// number it is in those of the input: value * unit^power, exact. None where that leaves the range
/// of normal numbers.
std::optional<double> in_input_units(double value, double unit, double power);

/// The same for many values, of which those that are rounding beside the largest may vanish. Throws
/// InvalidInput, naming what they are, where another one leaves the range.
Vector in_input_units(const Vector& values, double unit, double power, std::string_view what);

/// The same for values whose errors count beside the largest, as those of a form do: near the ends
/// of the range smaller ones lose digits that are rounding beside it. Throws where the largest
/// leaves the range.
Vector form_in_input_units(const Vector& values, double unit, double power, std::string_view what);

} // namespace polydec
