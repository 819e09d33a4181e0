// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/copies.h"

namespace polydec {

/// Two classes, each of some rank, that have an element in common, and whether it has the same sign
/// in both: 1 or -1.
struct SharedElement {
    GlobalIndex a, b;
    GlobalIndex sign;
    auto operator<=>(const SharedElement&) const = default;
};

/// The class over all ranks that a rank's class is part of.
struct SharedClass {
    GlobalIndex first; ///< least number of a part of it
    std::int8_t sign;  ///< relative to that part
    bool clashes;      ///< signs contradict each other somewhere on the way around
};

/// Collective: joins classes that have elements in common. Each rank's own have the numbers from
/// `first` on, `count` of them; a is one of its own. Those with anything in common are sent to rank
/// 0 and joined there, so their number should be far below that of cells.
std::vector<SharedClass> join_shared(const Ranks& ranks, GlobalIndex first, Index count,
                                     std::vector<SharedElement> shared);

/// Collective: joins parts of ranks, each of which numbers its own from 0 on, that have elements in
/// common: copies. of and signs have the part of each element, and its sign in there.
std::vector<SharedClass> join_parts(const Ranks& ranks, const Copies& copies,
                                    const std::vector<Index>& of,
                                    const std::vector<std::int8_t>& signs, Index count);

} // namespace polydec
