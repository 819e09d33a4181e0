// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <array>
#include <initializer_list>
#include <vector>

namespace polydec {

/// Numbers of the longest floating-point format there is, for the small matrices of one simplex.
using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

/// Mean over an n-simplex of a product of barycentric coordinates, given by their corners:
/// n! a! / (n + |a|)! for the multi-index a.
long double mean_of_product(int n, std::initializer_list<int> corners);

/// The quadratic polynomials lambda_i lambda_j, i <= j, of an n-simplex, by i, then j. They are a
/// basis of all quadratic polynomials, 1 being their sum with the weights 1 and 2 (i < j).
using Pair = std::array<int, 2>;
std::vector<Pair> quadratic_pairs(int n);

/// Means of products of two of these: a square matrix.
LongMatrix quadratic_products(int n, const std::vector<Pair>& pairs);

/// What the gradients of such polynomials are: that of pair q is the sum over a of lambda_a v_qa,
/// and v_qa the sum of the gradients of lambda_b over these (a, b).
std::array<Pair, 2> gradient_terms(const Pair& pair);

} // namespace polydec
