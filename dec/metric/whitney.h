// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"
#include "complex/pieces.h"
#include "dec/metric/simplex_metric.h"

#include <span>
#include <vector>

namespace polydec {

/// Mass matrix of the Whitney j-forms of one m-simplex with the given vertices, j <= m: inner
/// products of the forms of its j-faces, which are ordered and oriented by position in the vertex
/// list as subsets(m+1, j+1) has them. Symmetric positive definite; units length^(m-2j); depends on
/// edge lengths only. Source: Whitney 1957, integrated in closed form.
DenseMatrix whitney_mass(const Points& points, std::span<const Index> vertices, int j);

/// The sum over the n-simplices of their mass matrices, each times its weight (a number for each
/// n-simplex): the inner products of the Whitney k-forms, with weights 1. size(k) x size(k).
/// Throws InvalidInput for another number of weights, and if there is no degree k.
SparseMatrix whitney_mass(const Pieces& complex, const SimplexMetric& metric, int k,
                          const Vector& weights);

} // namespace polydec
