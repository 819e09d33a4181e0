// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/copies.h"

namespace polydec {

/// Two classes, of any ranks, with a common element: sign is 1 if it has the same sign in both,
/// else -1.
struct SharedElement {
    GlobalIndex a, b;
    GlobalIndex sign;
    auto operator<=>(const SharedElement&) const = default;
};

/// The class over all ranks that contains a rank's class.
struct SharedClass {
    GlobalIndex first; ///< least number of its parts
    std::int8_t sign;  ///< relative to that part
    bool clashes;      ///< signs are inconsistent around some loop
};

/// Collective: joins classes with common elements. Each rank's `count` own classes are numbered
/// from `first` on; a is an own class. Rank 0 joins all classes with common elements, so their
/// number should be far below the number of cells.
std::vector<SharedClass> join_shared(const Ranks& ranks, GlobalIndex first, Index count,
                                     std::vector<SharedElement> shared);

/// Collective: joins parts with common elements (copies); each rank numbers its own parts from 0
/// on. `of` and `signs` give the part of each element, and its sign there.
std::vector<SharedClass> join_parts(const Ranks& ranks, const Copies& copies,
                                    const std::vector<Index>& of,
                                    const std::vector<std::int8_t>& signs, Index count);

} // namespace polydec
