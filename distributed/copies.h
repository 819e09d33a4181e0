// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/ranks.h"

namespace polydec {

/// Which cells of one degree several ranks have: each has one owner, the others have copies.
struct Copies {
    Parcels<Index> out; ///< own cells, by the rank that has a copy of them
    Parcels<Index> in;  ///< copies, by the rank that owns them; in the order of its list for us
};

/// Collective: gives every copy the value of its owner.
template <class Value>
void refresh(const Ranks& ranks, const Copies& copies, std::vector<Value>& values) {
    auto parcels = ranks.empty_parcels<Value>();
    for (std::size_t r = 0; r < parcels.size(); ++r)
        for (const Index s : copies.out[r])
            parcels[r].push_back(values[s]);
    const auto arrived = ranks.deliver(parcels);
    for (std::size_t r = 0; r < arrived.size(); ++r)
        for (std::size_t i = 0; i < arrived[r].size(); ++i)
            values[copies.in[r][i]] = arrived[r][i];
}

/// Collective: calls take(own cell, value) for the value of every copy of it, in the order of
/// ranks.
template <class Value, class Take>
void collect(const Ranks& ranks, const Copies& copies, const std::vector<Value>& values,
             Take take) {
    auto parcels = ranks.empty_parcels<Value>();
    for (std::size_t r = 0; r < parcels.size(); ++r)
        for (const Index s : copies.in[r])
            parcels[r].push_back(values[s]);
    const auto arrived = ranks.deliver(parcels);
    for (std::size_t r = 0; r < arrived.size(); ++r)
        for (std::size_t i = 0; i < arrived[r].size(); ++i)
            take(copies.out[r][i], arrived[r][i]);
}

} // namespace polydec
