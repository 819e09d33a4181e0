// SPDX-License-Identifier: MIT
#include "dec/merging/merge.h"

#include "base/checks.h"
#include "complex/blocks.h"
#include "complex/components.h"
#include "complex/sides.h"
#include "dec/merging/absorb_flat.h"
#include "dec/merging/facet_defects.h"
#include "dec/merging/facet_links.h"
#include "dec/merging/flat_simplices.h"
#include "dec/merging/mean_spheres.h"
#include "dec/merging/straightness.h"
#include "dec/metric/rounding.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace polydec {

namespace {

/// The decomposition into cells of highest dimension.
struct TopCells {
    std::vector<bool> removed; // facets
    JoinedSimplices tops;
    bool exact; // whether everything removed is within rounding
};

/// Selects the facets that vanish: facets joined in ascending defect while the classes stay tight,
/// and facets that then lie inside a class and are degenerate enough themselves.
class FacetChoice {
public:
    FacetChoice(const Geometry& geometry, const FacetDefects& defects, double tolerance)
        : geometry_(geometry),
          defects_(defects),
          tolerance_(tolerance),
          is_in_space_(geometry.metric().ambient_dimension() == geometry.pieces().dimension()),
          sides_(geometry.pieces()) {}

    TopCells cells(const std::vector<bool>& kept) const {
        const Pieces& complex = geometry_.pieces();
        TopCells cells{std::vector<bool>(kept.size(), false),
                       {DisjointSets(complex.size(complex.dimension())), {}},
                       true};
        std::vector<FacetLink> inexact;
        const auto facets = static_cast<Index>(kept.size());
        for (Index f = 0; f < facets; ++f)
            if (defects_.degenerate[f] && !kept[f] && sides_.exist(f)) {
                if (defects_.defect[f] > 0)
                    inexact.push_back({sides_.first(f), sides_.second(f), defects_.defect[f],
                                       defects_.scale[f], sides_.relative_sign(f)});
                else
                    remove(f, cells);
            }
        join_links(inexact, tolerance_, cells.tops.sets);
        if (!defects_.flat.empty())
            absorb_flat(
                geometry_, defects_.flat,
                {free_sides(kept), defects_.scale, shortest_edges(complex, geometry_.volumes())},
                tolerance_, cells.tops.sets);
        for (Index f = 0; f < facets; ++f)
            if (!cells.removed[f] && !kept[f] && lies_in_a_class(f, cells))
                remove(f, cells);
        if (!defects_.flat.empty()) // which may be cut off from the class that took them
            cells.tops = join_tops(complex, cells.removed);
        return cells;
    }

    /// The centers of the cells.
    Centers centers(const TopCells& cells) const {
        if (!is_in_space_ || cells.exact)
            return {};
        MeanSpheres spheres(geometry_, defects_.flat);
        spheres.gather(DisjointSets(cells.tops.sets).firsts());
        return spheres.shared_centers();
    }

private:
    BothSides free_sides(const std::vector<bool>& kept) const {
        BothSides free(kept.size(), {-1, -1});
        for (Index f = 0; f < std::ssize(kept); ++f)
            if (!kept[f] && sides_.exist(f))
                free[f] = {sides_.first(f), sides_.second(f)};
        return free;
    }

    /// Whether both sides are pieces of one class. In space, everything between them is removed.
    bool lies_in_a_class(Index f, TopCells& cells) const {
        return (is_in_space_ ||
                defects_.defect[f] <= spread_limit * tolerance_ * defects_.scale[f]) &&
               sides_.exist(f) &&
               cells.tops.sets.find(sides_.first(f)).element ==
                   cells.tops.sets.find(sides_.second(f)).element;
    }

    void remove(Index f, TopCells& cells) const {
        const auto& flat = defects_.flat;
        cells.removed[f] = true;
        cells.tops.join(sides_.first(f), sides_.second(f), sides_.relative_sign(f));
        cells.exact = cells.exact && defects_.defect[f] == 0 &&
                      (flat.empty() || (!flat[sides_.first(f)] && !flat[sides_.second(f)]));
    }

    const Geometry& geometry_;
    const FacetDefects& defects_;
    double tolerance_;
    bool is_in_space_; // simplices have the dimension of space
    Sides sides_;
};

/// Keeps interfaces of each inadmissible block from being removed again: the worst facets, and in
/// lower degrees all.
void keep_worst(const std::vector<InadmissibleBlock>& blocks, const FacetDefects& defects, int n,
                CellMarks& kept) {
    for (const auto& block : blocks) {
        double worst = 0;
        if (block.dimension == n)
            for (const Index f : block.interfaces)
                worst = std::max(worst, defects.ratio(f));
        for (const Index s : block.interfaces)
            if (block.dimension < n || is_among_the_worst(defects.ratio(s), worst))
                kept[block.dimension - 1][s] = true;
    }
}

/// Marks the flat n-simplices beside a removed facet; empty if there are none.
std::vector<bool> flat_in_cells(const Pieces& complex, const std::vector<bool>& removed,
                                std::vector<bool> flat) {
    const int n = complex.dimension();
    for (std::size_t t = 0; t < flat.size(); ++t) {
        bool any = false;
        for (int i = 0; i <= n; ++i)
            any = any || removed[complex.face(n, static_cast<Index>(t), i)];
        flat[t] = flat[t] && any;
    }
    if (std::find(flat.begin(), flat.end(), true) == flat.end())
        flat.clear();
    return flat;
}

} // namespace

CosphericalMerging merge_cospherical(const Geometry& geometry, const MergeOptions& options,
                                     const KeptFacets& facets) {
    check_not_negative("the merge tolerance", options.tolerance);
    const Pieces& complex = geometry.pieces();
    const int n = complex.dimension();
    if (!facets.stay.empty())
        check_as_many("marks of facets", std::ssize(facets.stay), complex.size(n - 1));
    if (!facets.tags.empty())
        check_as_many("tags of facets", std::ssize(facets.tags), complex.size(n - 1));
    const auto defects = facet_defects(geometry, options);
    if (options.criterion == MergeCriterion::none ||
        (defects.degenerate.interior == 0 && defects.flat.empty()))
        return {Merging(complex), defects.degenerate, 0, geometry};

    CellMarks kept = no_marks(complex); // that must not be removed
    if (!facets.stay.empty())
        kept[n - 1] = facets.stay;
    const FacetChoice choice(geometry, defects, options.tolerance);

    // every round keeps at least one more simplex, so the loop ends
    for (int rounds = 0;; ++rounds) {
        TopCells cells = choice.cells(kept[n - 1]);
        const auto& removed = cells.removed;
        if (std::find(removed.begin(), removed.end(), true) == removed.end())
            return {Merging(complex), defects.degenerate, rounds, geometry};
        const Centers centers = choice.centers(cells);
        const Geometry shared =
            centers.are_circumcenters() ? geometry : Geometry(complex, geometry.metric(), centers);
        StraightnessTest test(shared, spread_limit * options.tolerance, options.tolerance);
        const auto straight = [&](int k, Index s, Index f, Index g) {
            const bool are_alike =
                k < n - 1 || facets.tags.empty() || facets.tags[f] == facets.tags[g];
            return are_alike && !kept[k - 1][s] && test(k, s, f, g);
        };
        Blocks blocks = join_blocks(complex, removed, std::move(cells.tops), straight);
        const auto inadmissible = inadmissible_blocks(complex, blocks);
        if (inadmissible.empty())
            return {Merging(complex, std::move(blocks)), defects.degenerate, rounds,
                    shared.with_flat(flat_in_cells(complex, removed, defects.flat))};
        keep_worst(inadmissible, defects, n, kept);
    }
}

CellVolumes
without_duals_beyond_the_boundary(const CellVolumes& volumes, const CofaceCounts& cofaces,
                                  const std::function<bool(Index cell)>& is_degenerate) {
    const int facets = volumes.dimension() - 1;
    const Vector& duals = volumes.dual(facets);
    Vector terms;
    for (Index f = 0; f < duals.size(); ++f) {
        if (cofaces[f] != 1 || !(duals[f] < 0) || is_zero(duals[f], volumes.terms(facets)[f]) ||
            !is_degenerate(f))
            continue;
        if (terms.size() == 0)
            terms = volumes.terms(facets).vector();
        constexpr double above = 1.1;
        terms[f] = above * std::abs(duals[f]) / rounding_of(1);
    }
    if (terms.size() == 0)
        return volumes;
    return volumes.with_dual(facets, duals, terms, volumes.rounding(facets).vector());
}

} // namespace polydec
