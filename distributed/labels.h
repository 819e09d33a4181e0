// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/local_complex.h"

namespace polydec {

/// The first simplex of a class, over all ranks.
struct Label {
    GlobalIndex number;
    std::int32_t owner; ///< its rank
    std::int32_t sign;  ///< of what is labeled, relative to it
};

/// Simplices of one degree in classes: for each the first one here of its class, itself if it is in
/// none, and its sign relative to that.
struct LocalClasses {
    std::vector<Index> first;
    std::vector<std::int8_t> sign;
    std::vector<bool> takes_part; ///< not those that are in no class at all
};

struct Labels {
    std::vector<Label> of;     ///< each simplex
    std::vector<bool> clashes; ///< where ranks contradict each other about its sign
};

/// Collective: labels of classes that go over several ranks where these have simplices in common.
/// They travel from rank to rank until nothing changes: as many rounds as the longest class passes
/// ranks.
Labels spread_labels(const Ranks& ranks, const LocalComplex& local, int k,
                     const LocalClasses& classes);

} // namespace polydec
