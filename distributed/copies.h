// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/ranks.h"

namespace polydec {

/// Cells of one degree shared by several ranks: each has one owner, the others have copies.
struct Copies {
    Parcels<Index> out; ///< own cells, by the rank that has a copy
    Parcels<Index> in;  ///< copies, by owner; in the order of the owner's list for this rank
};

/// Collective: sends value_of(cell) for `from`, and calls take(local cell, value) for `to`, which
/// has as many cells on each rank as the sender's `from`.
template <class ValueOf, class Take>
void exchange_values(const Ranks& ranks, const Parcels<Index>& from, const Parcels<Index>& to,
                     ValueOf value_of, Take take) {
    auto parcels = ranks.empty_parcels<std::decay_t<std::invoke_result_t<ValueOf, Index>>>();
    for (std::size_t r = 0; r < parcels.size(); ++r)
        for (const Index s : from[r])
            parcels[r].push_back(value_of(s));
    const auto arrived = ranks.deliver(std::move(parcels));
    for (std::size_t r = 0; r < arrived.size(); ++r)
        for (std::size_t i = 0; i < arrived[r].size(); ++i)
            take(to[r][i], arrived[r][i]);
}

/// Collective: calls take(copy, value) with the owner's value.
template <class ValueOf, class Take>
void tell_copies(const Ranks& ranks, const Copies& copies, ValueOf value_of, Take take) {
    exchange_values(ranks, copies.out, copies.in, value_of, take);
}

/// Collective: calls take(own cell, value) for the value of every copy, in the order of ranks.
template <class ValueOf, class Take>
void collect(const Ranks& ranks, const Copies& copies, ValueOf value_of, Take take) {
    exchange_values(ranks, copies.in, copies.out, value_of, take);
}

/// Collective: updates every copy with its owner's value.
template <class Value>
void refresh(const Ranks& ranks, const Copies& copies, std::vector<Value>& values) {
    tell_copies(
        ranks, copies, [&](Index s) -> Value { return values[s]; },
        [&](Index s, const Value& value) { values[s] = value; });
}

} // namespace polydec
