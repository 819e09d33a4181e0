// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <span>
#include <vector>

namespace polydec {

/// Mass matrix of the Whitney j-forms of one m-simplex with the given vertices, j <= m: inner
/// products of the forms of its j-faces, which are ordered and oriented by position in the vertex
/// list as subsets(m+1, j+1) has them. Symmetric positive definite; units length^(m-2j); depends on
/// edge lengths only. Source: Whitney 1957, integrated in closed form.
DenseMatrix whitney_mass(const Points& points, std::span<const Index> vertices, int j);

} // namespace polydec
