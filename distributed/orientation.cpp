// SPDX-License-Identifier: MIT
#include "distributed/orientation.h"

#include "base/permutation_sign.h"
#include "complex/disjoint_sets.h"
#include "distributed/shared_classes.h"

#include <cstdlib>
#include <limits>
#include <map>

namespace polydec {

namespace {

/// What a part knows of how it was given, relative to its sign.
struct Vote {
    GlobalIndex part;    ///< over all ranks
    GlobalIndex balance; ///< simplices that agree minus those that do not
    GlobalIndex first;   ///< number of its first simplex
    GlobalIndex given;   ///< whether that agrees: 1 or -1
    GlobalIndex one_sided;

    void add(const Vote& other) {
        balance += other.balance;
        one_sided |= other.one_sided;
        if (other.first < first) {
            first = other.first;
            given = other.given;
        }
    }
    /// 1 or -1: how its simplices are turned; 0: in no way.
    int decision() const {
        return one_sided != 0 ? 0 : static_cast<int>(balance == 0 ? given : balance > 0 ? 1 : -1);
    }
};

/// Parts of this rank, numbered from 0 on, and the sign of each simplex in its part.
struct LocalParts {
    std::vector<Index> of;
    std::vector<std::int8_t> signs;
    std::vector<bool> one_sided;
};

LocalParts parts_of(const LocalComplex& local, const std::vector<std::int8_t>& given) {
    const int n = local.dimension();
    const Index size = local.degree(n).size();
    const auto& counts = local.complex.coface_counts(n - 1);
    const auto& complete = local.degree(n - 1).complete;
    DisjointSets sets(size);
    std::vector<Index> met(counts.size(), 0), conflicts; // its number + 1, with the sign there
    for (Index t = 0; t < size; ++t)
        for (int i = 0; i <= n; ++i) {
            const Index f = local.complex.face(n, t, i);
            if (counts[f] != 2 || !complete[f] || given[t] == 0)
                continue;
            const int sign = i % 2 == 0 ? 1 : -1;
            if (met[f] == 0)
                met[f] = sign * (t + 1);
            else if (!sets.join(t, std::abs(met[f]) - 1, met[f] > 0 ? -sign : sign))
                conflicts.push_back(t);
        }
    LocalParts parts;
    Index next = 0;
    for (Index t = 0; t < size; ++t) {
        const auto [first, sign] = sets.find(t);
        parts.of.push_back(first == t ? next++ : parts.of[first]);
        parts.signs.push_back(sign);
    }
    parts.one_sided.assign(next, false);
    for (const Index t : conflicts)
        parts.one_sided[parts.of[t]] = true;
    return parts;
}

/// What is decided for each part that has votes, at the rank where its number lies.
std::vector<int> decide(const Ranks& ranks, const std::vector<Vote>& votes) {
    auto parcels = ranks.empty_parcels<Vote>();
    std::vector<int> whom;
    for (const Vote& vote : votes) {
        whom.push_back(static_cast<int>(vote.part % ranks.size()));
        parcels[whom.back()].push_back(vote);
    }
    const auto arrived = ranks.deliver(std::move(parcels));
    std::map<GlobalIndex, Vote> totals;
    ranks.together("orientation", [&] {
        for (const auto& parcel : arrived)
            for (const Vote& vote : parcel)
                if (const auto [total, is_new] = totals.emplace(vote.part, vote); !is_new)
                    total->second.add(vote);
    });
    std::vector<GlobalIndex> numbers;
    for (const Vote& vote : votes)
        numbers.push_back(vote.part);
    return ranks.ask<int>("orientation", whom, numbers,
                          [&](GlobalIndex part) { return totals.at(part).decision(); });
}

} // namespace

std::vector<std::int8_t> coherent(const Ranks& ranks, const LocalComplex& local,
                                  const std::vector<std::int8_t>& given) {
    const int n = local.dimension();
    const auto& tops = local.degree(n);
    const auto parts = ranks.together("orientation", [&] { return parts_of(local, given); });
    const auto shared = join_parts(ranks, tops.copies, parts.of, parts.signs,
                                   static_cast<Index>(parts.one_sided.size()));
    std::vector<Vote> votes;
    for (std::size_t part = 0; part < shared.size(); ++part)
        votes.push_back({shared[part].first, 0, std::numeric_limits<GlobalIndex>::max(), 1,
                         parts.one_sided[part] || shared[part].clashes});
    for (Index t = 0; t < tops.size(); ++t) {
        Vote& vote = votes[parts.of[t]];
        const int agrees = given[t] * parts.signs[t] * shared[parts.of[t]].sign;
        if (local.owns(ranks, n, t))
            vote.add({0, agrees, tops.number[t], agrees, 0});
    }
    const auto decisions = decide(ranks, votes);
    auto signs = parts.signs;
    for (Index t = 0; t < tops.size(); ++t)
        signs[t] =
            static_cast<std::int8_t>(signs[t] * decisions[parts.of[t]] * shared[parts.of[t]].sign);
    return signs;
}

void orient(const Ranks& ranks, const Stars& stars, LocalComplex& local) {
    const int n = local.dimension();
    std::vector<std::int8_t> given;
    ranks.together("orientation", [&] {
        const Simplices rows = by_local_vertex(stars); // their order is all that matters
        for (Index t = 0; t < rows.rows(); ++t) {
            const auto row = rows.row(local.complex.input_row(t));
            given.push_back(static_cast<std::int8_t>(permutation_sign({row.begin(), row.end()})));
        }
    });
    auto orientations = coherent(ranks, local, given);
    GlobalIndex turned = 0;
    bool orientable = true;
    for (Index t = 0; t < std::ssize(given); ++t) {
        orientable = orientable && orientations[t] != 0;
        if (orientations[t] == 0)
            orientations[t] = given[t];
        turned += local.owns(ranks, n, t) && orientations[t] != given[t] ? 1 : 0;
    }
    local.turned = ranks.sum(turned);
    local.orientable = !ranks.any(!orientable);
    ranks.together("orientation", [&] {
        local.complex = local.complex.oriented(std::move(orientations), local.orientable);
    });
}

} // namespace polydec
