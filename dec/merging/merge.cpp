// SPDX-License-Identifier: MIT
#include "dec/merging/merge.h"

#include "base/checks.h"
#include "base/errors.h"
#include "complex/disjoint_sets.h"
#include "dec/merging/facet_defects.h"
#include "dec/merging/straightness.h"
#include "dec/metric/cell_volumes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace polydec {

namespace {

using Kept = std::vector<std::vector<bool>>; // by degree: simplices that must not be removed

/// What a class may gather, and what still may be removed inside one, in tolerances.
constexpr double spread_limit = 10;

/// Relative defects nearer than this count as equal: in symmetric meshes they are, but for
/// rounding.
constexpr double tie = 1e-12;

/// Classes of n-simplices, with the defects that each has gathered at its root.
struct Classes {
    explicit Classes(Index size) : sets(size), spread(size, 0.0) {}

    DisjointSets sets;
    std::vector<double> spread;
};

/// Which facets vanish: those joined in ascending defect while the classes stay tight, and those
/// that then lie inside a class and are degenerate enough themselves.
class FacetChoice {
public:
    FacetChoice(const Pieces& complex, const FacetDefects& defects, double tolerance)
        : complex_(complex), defects_(defects), limit_(spread_limit * tolerance) {
        const int n = complex.dimension();
        const auto& counts = complex.coface_counts(n - 1);
        sides_.resize(complex.size(n - 1), {-1, -1});
        for (Index t = 0; t < complex.size(n); ++t)
            for (int i = 0; i <= n; ++i)
                if (const Index f = complex.face(n, t, i); counts[f] == 2)
                    sides_[f][sides_[f][0] < 0 ? 0 : 1] = t;
        for (Index f = 0; f < complex.size(n - 1); ++f)
            if (counts[f] == 2 && defects.degenerate[f])
                candidates_.push_back(f);
        arrange_candidates();
    }

    std::vector<bool> removed(const std::vector<bool>& kept) const {
        Classes classes(complex_.size(complex_.dimension()));
        for (std::size_t i = 0; i < exact_; ++i)
            if (const Index f = candidates_[i]; !kept[f])
                classes.sets.join(sides_[f][0], sides_[f][1]);
        std::vector<Index> place(static_cast<std::size_t>(complex_.size(complex_.dimension())), -1);
        for (std::size_t group = 1; group < group_begins_.size(); ++group) {
            std::vector<Index> tied;
            for (std::size_t i = group_begins_[group - 1]; i < group_begins_[group]; ++i)
                if (!kept[candidates_[i]])
                    tied.push_back(candidates_[i]);
            join_tied(tied, classes, place);
        }

        std::vector<bool> result(sides_.size(), false);
        for (std::size_t f = 0; f < sides_.size(); ++f)
            result[f] =
                sides_[f][1] >= 0 && !kept[f] && defects_.defect[f] <= limit_ * defects_.scale[f] &&
                classes.sets.find(sides_[f][0]).element == classes.sets.find(sides_[f][1]).element;
        return result;
    }

private:
    void arrange_candidates();
    void join_tied(const std::vector<Index>& tied, Classes& classes,
                   std::vector<Index>& place) const;

    const Pieces& complex_;
    const FacetDefects& defects_;
    double limit_;
    std::vector<std::array<Index, 2>> sides_; // cofaces of facets with two, -1 otherwise
    std::vector<Index> candidates_;           // in groups of ascending relative defect
    std::size_t exact_ = 0;                   // of these have none, and add nothing to a class
    std::vector<std::size_t> group_begins_;   // of candidates whose defects tie, and the end
};

/// Most candidates are exact, and most of the others tie with the best: only the rest is sorted.
void FacetChoice::arrange_candidates() {
    const auto ratio = [&](Index f) { return defects_.ratio(f); };
    const auto inexact = std::stable_partition(candidates_.begin(), candidates_.end(),
                                               [&](Index f) { return defects_.defect[f] == 0; });
    exact_ = static_cast<std::size_t>(inexact - candidates_.begin());
    group_begins_ = {exact_};
    double reach = std::numeric_limits<double>::infinity();
    for (auto f = inexact; f != candidates_.end(); ++f)
        reach = std::min(reach, ratio(*f) + tie);
    const auto rest = std::stable_partition(inexact, candidates_.end(),
                                            [&](Index f) { return ratio(f) <= reach; });
    std::stable_sort(rest, candidates_.end(),
                     [&](Index f, Index g) { return ratio(f) < ratio(g); });

    // measured from the first of a group, so that values close together do not chain
    for (auto f = rest; f != candidates_.end(); ++f)
        if (ratio(*f) > reach) {
            reach = ratio(*f) + tie;
            group_begins_.push_back(static_cast<std::size_t>(f - candidates_.begin()));
        }
    group_begins_.push_back(candidates_.size());
}

/// Of the facets with equal defect, those that hang together are all joined or none: which of them
/// comes first must not matter. place is -1 for all n-simplices, before and after.
void FacetChoice::join_tied(const std::vector<Index>& tied, Classes& classes,
                            std::vector<Index>& place) const {
    struct Link {
        Index facet, a, b; // classes on both sides, by place in `roots`
    };
    std::vector<Link> links;
    std::vector<Index> roots;
    const auto place_of = [&](Index root) {
        if (place[root] < 0) {
            place[root] = static_cast<Index>(roots.size());
            roots.push_back(root);
        }
        return place[root];
    };
    for (const Index f : tied) {
        const Index a = classes.sets.find(sides_[f][0]).element;
        const Index b = classes.sets.find(sides_[f][1]).element;
        if (a != b) {
            const Index place_of_a = place_of(a);
            links.push_back({f, place_of_a, place_of(b)});
        }
    }
    for (const Index root : roots)
        place[root] = -1;
    DisjointSets groups(static_cast<Index>(roots.size()));
    for (const Link& link : links)
        groups.join(link.a, link.b);

    std::vector<double> gathered(roots.size(), 0.0);
    std::vector<double> allowed(roots.size(), std::numeric_limits<double>::infinity());
    for (std::size_t i = 0; i < roots.size(); ++i)
        gathered[groups.find(static_cast<Index>(i)).element] += classes.spread[roots[i]];
    for (const Link& link : links) {
        const Index group = groups.find(link.a).element;
        gathered[group] += defects_.defect[link.facet];
        allowed[group] = std::min(allowed[group], limit_ * defects_.scale[link.facet]);
    }
    for (const Link& link : links) {
        const Index group = groups.find(link.a).element;
        if (gathered[group] > allowed[group])
            continue;
        classes.sets.join(roots[link.a], roots[link.b]);
        classes.spread[classes.sets.find(roots[link.a]).element] = gathered[group];
    }
}

/// Keeps the worst interfaces of each inadmissible block from being removed again: of facets those
/// within a factor of two of the worst, so that the choice does not hang on numbering or rounding;
/// in lower degrees all.
void keep_worst(const std::vector<InadmissibleBlock>& blocks, const FacetDefects& defects, int n,
                Kept& kept) {
    for (const auto& block : blocks) {
        double worst = 0;
        if (block.dimension == n)
            for (const Index f : block.interfaces)
                worst = std::max(worst, defects.ratio(f));
        for (const Index s : block.interfaces)
            if (block.dimension < n || defects.ratio(s) >= worst / 2)
                kept[block.dimension - 1][s] = true;
    }
}

} // namespace

CosphericalMerging merge_cospherical(Pieces complex, const SimplexMetric& metric,
                                     const CellVolumes& volumes, const MergeOptions& options,
                                     const std::vector<bool>& stays) {
    if (!(options.tolerance >= 0) || !std::isfinite(options.tolerance))
        throw InvalidInput(fmt::format("the merge tolerance is {}: expected a number >= 0, such as "
                                       "1e-4",
                                       options.tolerance));
    check_fit(complex, volumes);
    const int n = complex.dimension();
    if (!stays.empty())
        check_as_many("marks of facets", static_cast<Index>(stays.size()), complex.size(n - 1));
    const auto defects = facet_defects(complex, metric, volumes, options);
    if (options.criterion == MergeCriterion::none)
        return {unmerged(std::move(complex)), defects.degenerate, 0};

    Kept kept;
    for (int k = 0; k < n; ++k)
        kept.emplace_back(complex.size(k), false);
    if (!stays.empty())
        kept[n - 1] = stays;
    const FacetChoice choice(complex, defects, options.tolerance);
    StraightnessTest test(complex, metric, volumes, options.tolerance);
    const auto straight = [&](int k, Index s, Index f, Index g) {
        return !kept[k - 1][s] && test(k, s, f, g);
    };

    // every round keeps at least one more simplex, so this ends
    for (int rounds = 0;; ++rounds) {
        const auto removed = choice.removed(kept[n - 1]);
        if (std::find(removed.begin(), removed.end(), true) == removed.end())
            return {unmerged(std::move(complex)), defects.degenerate, rounds};
        const auto blocks = join_blocks(complex, removed, straight);
        const auto inadmissible = inadmissible_blocks(complex, blocks);
        if (inadmissible.empty())
            return {Merging(std::move(complex), blocks), defects.degenerate, rounds};
        keep_worst(inadmissible, defects, n, kept);
    }
}

} // namespace polydec
