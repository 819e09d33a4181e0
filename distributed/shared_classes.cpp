// SPDX-License-Identifier: MIT
#include "distributed/shared_classes.h"

#include "base/lists.h"
#include "complex/disjoint_sets.h"
#include "distributed/number_places.h"

namespace polydec {

namespace {

/// The classes of all that occur, in ascending order of their numbers.
struct Solved {
    std::vector<GlobalIndex> numbers;
    std::vector<SharedClass> classes;
};

Solved solve(const std::vector<SharedElement>& shared) {
    std::vector<GlobalIndex> ends;
    for (const auto& [a, b, sign] : shared)
        ends.insert(ends.end(), {a, b});
    const NumberPlaces place(ends);
    const auto& numbers = place.numbers();
    const auto count = static_cast<Index>(numbers.size());
    DisjointSets sets(count);
    std::vector<Index> clashing;
    for (const auto& [a, b, sign] : shared)
        if (!sets.join(place(a), place(b), static_cast<int>(sign)))
            clashing.push_back(place(a));
    std::vector<bool> clashes(numbers.size(), false);
    for (const Index i : clashing)
        clashes[sets.find(i).element] = true;
    Solved solved{numbers, {}};
    for (Index i = 0; i < count; ++i) {
        const auto [first, sign] = sets.find(i);
        solved.classes.push_back({numbers[first], sign, clashes[first]});
    }
    return solved;
}

} // namespace

std::vector<SharedClass> join_shared(const Ranks& ranks, GlobalIndex first, Index count,
                                     std::vector<SharedElement> shared) {
    sort_unique(shared);
    auto edges = ranks.empty_parcels<SharedElement>();
    edges[0] = std::move(shared);
    const auto at_first = ranks.deliver(std::move(edges));
    const Solved solved =
        ranks.together("shared classes", [&] { return solve(unpacked(at_first)); });

    // back to the ranks whose classes they are
    const Stretches stretches(ranks, first);
    struct Answer {
        GlobalIndex number;
        SharedClass of;
    };
    auto answers = ranks.empty_parcels<Answer>();
    for (std::size_t i = 0; i < solved.numbers.size(); ++i)
        answers[stretches.rank_of(solved.numbers[i])].push_back(
            {solved.numbers[i], solved.classes[i]});
    std::vector<SharedClass> result;
    for (Index c = 0; c < count; ++c)
        result.push_back({first + c, 1, false});
    const auto arrived = ranks.deliver(std::move(answers));
    for (const auto& [number, of] : arrived[0])
        result[number - first] = of;
    return result;
}

std::vector<SharedClass> join_parts(const Ranks& ranks, const Copies& copies,
                                    const std::vector<Index>& of,
                                    const std::vector<std::int8_t>& signs, Index count) {
    const GlobalIndex first = ranks.sum_before(count);
    struct Place {
        GlobalIndex part, sign;
    };
    std::vector<SharedElement> shared;
    tell_copies(
        ranks, copies,
        [&](Index element) -> Place {
            return {first + of[element], signs[element]};
        },
        [&](Index element, const Place& of_owner) {
            shared.push_back({first + of[element], of_owner.part, signs[element] * of_owner.sign});
        });
    return join_shared(ranks, first, count, std::move(shared));
}

} // namespace polydec
