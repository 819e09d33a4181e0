// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <array>
#include <initializer_list>
#include <vector>

namespace polydec {

/// Numbers in the longest native floating-point format, for the small matrices of one simplex.
using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

/// Mean over an n-simplex of a product of barycentric coordinates, listed by corner: n! a! / (n +
/// |a|)! for the multi-index a.
long double mean_of_product(int n, std::initializer_list<int> corners);

/// The quadratic polynomials lambda_i lambda_j, i <= j, of an n-simplex, ordered by i, then j. They
/// are a basis of all quadratic polynomials; with weights 1 and 2 (i < j) they sum to 1.
using Pair = std::array<int, 2>;
std::vector<Pair> quadratic_pairs(int n);

/// Means of products of two of these polynomials: a square matrix.
LongMatrix quadratic_products(int n, const std::vector<Pair>& pairs);

/// Terms of the gradient of polynomial q: the sum over a of lambda_a v_qa, where v_qa is the sum of
/// the gradients of lambda_b over these pairs (a, b).
std::array<Pair, 2> gradient_terms(const Pair& pair);

} // namespace polydec
