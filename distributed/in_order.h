// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/ranks.h"

namespace polydec {

/// Collective: the places of different lists of numbers in the lexicographic order of those of all
/// ranks. `lists` are rows of `width` numbers each, ascending; the first ones below `below`. Each
/// rank orders the lists that begin in its stretch. Memory (width + 2) * 8 bytes a list.
struct Ordered {
    std::vector<GlobalIndex> places;
    GlobalIndex count = 0; ///< of all ranks
};
Ordered places_in_order(const Ranks& ranks, const std::vector<GlobalIndex>& lists, int width,
                        GlobalIndex below);

} // namespace polydec
