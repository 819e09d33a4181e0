// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/length_mesh.h"

#include <optional>
#include <string_view>

namespace polydec {

/// A unit of length for a mesh that keeps products of its lengths in range. The longest edge L (for
/// points, its largest coordinate difference) determines it: 1 if L is between 2^-40 and 2^40 (in
/// more than six dimensions n, 2^-(240/n) and 2^(240/n)), else the power of 4 that scales L to 1 to
/// 8. Vertex numbers must be valid.
double unit_of_length(const Mesh& mesh);
double unit_of_length(const LengthMesh& mesh);

/// The same for a mesh known in parts: from half the longest edge's largest coordinate difference,
/// and the largest coordinate, over all parts.
double unit_of_length(double half_of_longest, double farthest, int dimension);

/// Half the largest difference of coordinates between two corners of a simplex.
double half_of_longest_edge(const Points& points, const Simplices& simplices);

/// The mesh with its points divided by a unit, a power of two: exact, except for coordinates of at
/// most 2^-1022 units.
Mesh in_units(Mesh mesh, double unit);
Points in_units(Points points, double unit);

/// Converts a quantity measured in units (a power of 4), to an integer or half-integer power, to
/// input units: value * unit^power, exact. None if the result is not a normal number.
std::optional<double> in_input_units(double value, double unit, double power);

/// The same for many values; values at rounding level relative to the largest may underflow. Throws
/// InvalidInput, naming the quantity, if another one leaves the range.
Vector in_input_units(const Vector& values, double unit, double power, std::string_view what);
SparseMatrix in_input_units(SparseMatrix matrix, double unit, double power, std::string_view what);

/// The same for values whose errors count relative to the largest, such as a form's: near the
/// limits of the range, smaller ones lose digits at rounding level. Throws if the largest leaves
/// the range.
Vector form_in_input_units(const Vector& values, double unit, double power, std::string_view what);

} // namespace polydec
