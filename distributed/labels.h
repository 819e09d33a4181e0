// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/local_complex.h"

namespace polydec {

/// The first simplex of a class, over all ranks.
struct Label {
    GlobalIndex number;
    std::int32_t owner; ///< its rank
    std::int32_t sign;  ///< of the labeled simplex, relative to it
};

/// Classes of simplices of one degree: for each simplex, the first one here of its class (itself if
/// it has none), and its sign relative to that.
struct LocalClasses {
    /// All simplices take part, with the sign 1.
    explicit LocalClasses(std::vector<Index> firsts)
        : first(std::move(firsts)), sign(first.size(), 1), takes_part(first.size(), true) {}

    std::vector<Index> first;
    std::vector<std::int8_t> sign;
    std::vector<bool> takes_part; ///< false for simplices in no class
};

struct Labels {
    std::vector<Label> of;     ///< each simplex
    std::vector<bool> clashes; ///< ranks disagree about its sign
};

/// Collective: labels of classes that extend over several ranks through shared simplices. Labels
/// spread from rank to rank until nothing changes: the number of rounds is the largest number of
/// rank changes along a class.
Labels spread_labels(const Ranks& ranks, const LocalComplex& local, int k,
                     const LocalClasses& classes);

} // namespace polydec
