// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

namespace polydec {

/// Throws InvalidInput "generator: name = value is outside least .. most".
void check_count(std::string_view generator, std::string_view name, std::int64_t value,
                 std::int64_t least, std::int64_t most = std::numeric_limits<Index>::max());

/// Throws InvalidInput unless the value is positive and finite.
void check_length(std::string_view generator, std::string_view name, double value);

/// Throws InvalidInput if the requested mesh of dimension n exceeds the range of Index in vertices
/// or cells, IoError if it exceeds memory_limit(). Counts are doubles, so that products of
/// arguments do not overflow.
void check_sizes(std::string_view generator, double vertices, double cells, int n = 3);

/// The number of cubes in a box with counts[k] >= 1 cubes along axis k = 0 .. n-1, as a double.
/// Throws InvalidInput if there are not n counts, or if a count, the edge or a side of the box is
/// not positive and finite.
double check_cubes(std::string_view generator, const std::vector<int>& counts, int n, double edge);

/// (cos, sin) of i/n of a full turn, 0 <= i <= n, n >= 1. Points related by symmetries of the
/// square agree to the last bit.
Eigen::Vector2d circle_point(std::int64_t i, std::int64_t n);

} // namespace polydec
