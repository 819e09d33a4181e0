// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace polydec {

/// Ascending lists of the (size)-subsets of 0..count-1, in lexicographic order. Throws InvalidInput
/// for numbers below 0.
std::vector<std::vector<int>> subsets(int count, int size);

/// The numbers 0..count-1 missing in an ascending list, ascending.
std::vector<int> complement(int count, const std::vector<int>& list);

} // namespace polydec
