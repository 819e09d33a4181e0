// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"
#include "complex/pieces.h"
#include "dec/metric/simplex_layout.h"

#include <span>

namespace polydec {

/// Mass matrix of the Whitney j-forms of one m-simplex with the given vertices, j <= m: inner
/// products of the forms of its j-faces, ordered and oriented by position in the vertex list as in
/// subsets(m+1, j+1). Symmetric positive definite; units length^(m-2j); depends only on edge
/// lengths. Source: Whitney 1957, integrated in closed form.
DenseMatrix whitney_mass(const Points& points, std::span<const Index> vertices, int j);

/// Sum of the mass matrices of the m-simplices, each times its weight (one per m-simplex); with
/// weights 1, the inner products of the Whitney k-forms on them. size(k) x size(k).
/// Throws InvalidInput for a wrong number of weights, and unless k <= m <= n.
SparseMatrix whitney_mass(const Pieces& complex, const SimplexMetric& metric, int m, int k,
                          const Vector& weights);

} // namespace polydec
