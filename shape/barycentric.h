// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <array>
#include <initializer_list>

namespace polydec {

/// Numbers in the longest native floating-point format, for the small matrices of one simplex.
using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

/// Mean over an n-simplex of a product of barycentric coordinates, listed by corner: n! a! / (n +
/// |a|)! for the multi-index a.
long double mean_of_product(int n, std::initializer_list<int> corners);

/// Two corners i, j of a simplex: the polynomial lambda_i lambda_j, or a point between them.
using Pair = std::array<int, 2>;

} // namespace polydec
