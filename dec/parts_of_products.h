// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"

namespace polydec {

/// The part of |E||*E| that lies in each n-cell, for all its k-cells E: size(n) x size(k). Its
/// columns sum to |E||*E|, *E between these centers.
SparseMatrix parts_of_products(const Discretization& mesh, int k, const Centers& centers);

} // namespace polydec
