// SPDX-License-Identifier: MIT
#include "distributed/in_order.h"

#include <algorithm>
#include <numeric>

namespace polydec {

namespace {

/// The places of lists that several ranks have sent.
Parcels<GlobalIndex> places_of(const Parcels<GlobalIndex>& arrived, int width) {
    std::vector<const GlobalIndex*> lists;
    for (const auto& parcel : arrived)
        for (auto list = parcel.data(); list != parcel.data() + parcel.size(); list += width)
            lists.push_back(list);
    std::vector<std::size_t> order(lists.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto before = [&](std::size_t a, std::size_t b) {
        return std::lexicographical_compare(lists[a], lists[a] + width, lists[b], lists[b] + width);
    };
    std::sort(order.begin(), order.end(), before);
    std::vector<GlobalIndex> place(lists.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        place[order[i]] = static_cast<GlobalIndex>(i);

    Parcels<GlobalIndex> places(arrived.size());
    auto next = place.begin();
    for (std::size_t r = 0; r < arrived.size(); ++r) {
        const auto end = next + static_cast<std::ptrdiff_t>(arrived[r].size()) / width;
        places[r].assign(next, end);
        next = end;
    }
    return places;
}

/// Whether the lists of every rank come before those of the next one, as they do where ranks own
/// stretches of vertices.
bool are_in_order(const Ranks& ranks, const std::vector<GlobalIndex>& lists, int width) {
    std::vector<GlobalIndex> ends; // the first and the last list of every rank that has any
    if (!lists.empty()) {
        ends.assign(lists.begin(), lists.begin() + width);
        ends.insert(ends.end(), lists.end() - width, lists.end());
    }
    ends = ranks.of_all(ends);
    for (auto list = ends.begin(); list + width < ends.end(); list += width)
        if (std::lexicographical_compare(list + width, std::min(list + 2 * width, ends.end()), list,
                                         list + width))
            return false;
    return true;
}

} // namespace

Ordered places_in_order(const Ranks& ranks, const std::vector<GlobalIndex>& lists, int width,
                        GlobalIndex below) {
    if (are_in_order(ranks, lists, width)) {
        const GlobalIndex own = std::ssize(lists) / width;
        Ordered result{std::vector<GlobalIndex>(static_cast<std::size_t>(own)), ranks.sum(own)};
        std::iota(result.places.begin(), result.places.end(), ranks.sum_before(own));
        return result;
    }
    const EqualStretches stretches(below, ranks.size());
    auto parcels = ranks.empty_parcels<GlobalIndex>();
    for (auto list = lists.begin(); list != lists.end(); list += width) {
        auto& parcel = parcels[stretches.rank_of(*list)];
        parcel.insert(parcel.end(), list, list + width);
    }
    const auto arrived = ranks.deliver(std::move(parcels));
    auto places = ranks.together("order", [&] { return places_of(arrived, width); });
    GlobalIndex count = 0;
    for (const auto& of_rank : places)
        count += std::ssize(of_rank);
    const GlobalIndex before = ranks.sum_before(count);
    for (auto& of_rank : places)
        for (GlobalIndex& place : of_rank)
            place += before;
    const GlobalIndex all = ranks.sum(count);
    // lists ascend, and so do the ranks that ordered them
    return {unpacked(ranks.deliver(std::move(places))), all};
}

} // namespace polydec
