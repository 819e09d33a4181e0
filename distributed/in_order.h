// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/ranks.h"

namespace polydec {

/// Collective: the places of distinct lists of numbers in the lexicographic order over all ranks.
/// `lists` are ascending rows of `width` numbers each; first numbers are below `below`. Each rank
/// sorts the lists whose first number is in its range. Memory (width + 2) * 8 bytes a list.
struct Ordered {
    std::vector<GlobalIndex> places;
    GlobalIndex count = 0; ///< of all ranks
};
Ordered places_in_order(const Ranks& ranks, const std::vector<GlobalIndex>& lists, int width,
                        GlobalIndex below);

} // namespace polydec
