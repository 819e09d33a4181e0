// SPDX-License-Identifier: MIT
#include "distributed/merging.h"

#include "base/checks.h"
#include "base/lists.h"
#include "complex/blocks.h"
#include "complex/open_balls.h"
#include "dec/merging/facet_links.h"
#include "dec/merging/straightness.h"
#include "dec/metric/geometry.h"
#include "distributed/facet_classes.h"
#include "distributed/labels.h"

#include <algorithm>

namespace polydec {

namespace {

using Carriers = std::vector<std::vector<Carrier>>;

/// What a rank knows of what makes a cell no ball: its part of the Euler number without the first
/// piece, how many of its simplices have at least two dimensions less, and whether anything else is
/// amiss.
struct Flaw {
    BlockName cell;
    GlobalIndex euler, below_interfaces, is_amiss;
};

/// What is known of each cell together.
std::vector<Flaw> summed(std::vector<Flaw> flaws) {
    std::sort(flaws.begin(), flaws.end(),
              [](const Flaw& a, const Flaw& b) { return a.cell < b.cell; });
    std::vector<Flaw> sums;
    for (const Flaw& flaw : flaws) {
        if (sums.empty() || sums.back().cell != flaw.cell)
            sums.push_back({flaw.cell, 0, 0, 0});
        sums.back().euler += flaw.euler;
        sums.back().below_interfaces += flaw.below_interfaces;
        sums.back().is_amiss |= flaw.is_amiss;
    }
    return sums;
}

class Rounds {
public:
    Rounds(const Ranks& ranks, const LocalComplex& local, const CellVolumes& volumes,
           const MergeOptions& options)
        : ranks_(ranks),
          local_(local),
          volumes_(volumes),
          options_(options),
          n_(local.dimension()),
          defects_(measure_facets(ranks, local, volumes, options)) {
        for (int k = 0; k < n_; ++k)
            kept_.emplace_back(static_cast<std::size_t>(local.degree(k).size()), 0);
    }

    DistributedMerging run();

private:
    Blocks join(const FacetClasses& classes, const CellVolumes& of_pieces) const;
    std::vector<Carrier> pieces_of(const Blocks& blocks, int k);
    Carriers carriers_of(const Blocks& blocks);
    std::vector<Flaw> local_flaws(const Blocks& blocks, const Carriers& carriers) const;
    std::vector<BlockName> bad_cells(const std::vector<Flaw>& flaws,
                                     const Carriers& carriers) const;
    std::vector<BlockName> no_balls_among(const std::vector<BlockName>& cells,
                                          const Carriers& carriers) const;
    int rank_for(const BlockName& cell) const {
        const auto k = static_cast<int>(cell.dimension);
        return EqualStretches(local_.degree(k).count, ranks_.size()).rank_of(cell.first);
    }
    void keep_worst(const std::vector<BlockName>& bad, const Carriers& carriers);
    DistributedMerging unmerged(DistributedMerging result) const;

    const Ranks& ranks_;
    const LocalComplex& local_;
    const CellVolumes& volumes_;
    const MergeOptions& options_;
    int n_;
    FacetDefects defects_;
    KeptSimplices kept_;
    std::vector<BlockName> clashing_; // that ranks contradict each other about
};

/// Only what is complete here may be removed for lying straight. What is not may seem to lie inside
/// a larger block; that spreads to nothing that is complete, and the owner's word replaces it.
Blocks Rounds::join(const FacetClasses& classes, const CellVolumes& of_pieces) const {
    const std::vector<bool> removed(classes.removed.begin(), classes.removed.end());
    StraightnessTest test({local_.complex, local_.points, of_pieces},
                          spread_limit * options_.tolerance, options_.tolerance);
    return join_blocks(local_.complex, removed, [&](int k, Index s, Index f, Index g) {
        return local_.degree(k - 1).complete[s] && kept_[k - 1][s] == 0 && test(k, s, f, g);
    });
}

/// What is known of k-simplices that are pieces, by the ranks together.
std::vector<Carrier> Rounds::pieces_of(const Blocks& blocks, int k) {
    const auto& own = blocks.carriers[k];
    LocalClasses classes(numbers_below(std::ssize(own)));
    classes.sign = blocks.signs[k];
    for (std::size_t s = 0; s < own.size(); ++s)
        if (own[s].dimension == k)
            classes.first[s] = own[s].cell;
        else
            classes.takes_part[s] = false;
    const Labels labels = spread_labels(ranks_, local_, k, classes);
    std::vector<Carrier> carriers;
    carriers.reserve(own.size());
    for (std::size_t s = 0; s < own.size(); ++s) {
        const auto& [number, owner, sign] = labels.of[s];
        carriers.push_back(
            {static_cast<std::int8_t>(k), static_cast<std::int8_t>(sign), owner, number});
        if (labels.clashes[s])
            clashing_.push_back({k, number});
    }
    for (const Index piece : blocks.twisted[k])
        clashing_.push_back({k, labels.of[piece].number});
    return carriers;
}

/// Downwards, since what is no piece itself lies in a cell of higher degree, of which a piece has
/// all corners of it, and so is complete where it is.
Carriers Rounds::carriers_of(const Blocks& blocks) {
    Carriers carriers(static_cast<std::size_t>(n_) + 1);
    clashing_.clear();
    for (int k = n_; k >= 0; --k) {
        const auto& own = blocks.carriers[k];
        carriers[k] = pieces_of(blocks, k);
        for (std::size_t s = 0; s < own.size(); ++s)
            if (const auto& [dimension, piece] = own[s]; dimension != k) {
                const Carrier& cell = carriers[dimension][piece];
                carriers[k][s] = {static_cast<std::int8_t>(dimension), 0, cell.owner, cell.first};
            }
        refresh(ranks_, local_.degree(k).copies, carriers[k]);
    }
    return carriers;
}

std::vector<Flaw> Rounds::local_flaws(const Blocks& blocks, const Carriers& carriers) const {
    std::vector<Flaw> flaws;
    for (int k = 0; k <= n_; ++k)
        for (Index s = 0; s < local_.degree(k).size(); ++s) {
            const auto& [dimension, sign, owner, first] = carriers[k][s];
            if (local_.owns(ranks_, k, s) && (dimension > k || first != local_.degree(k).number[s]))
                flaws.push_back(
                    {{dimension, first}, k % 2 == 0 ? 1 : -1, dimension > k + 1 ? 1 : 0, 0});
        }
    for (const BlockName& cell : clashing_)
        flaws.push_back({cell, 0, 0, 1});
    const FaceTable ends = local_.complex.faces(1);
    for (Index e = 0; e < local_.degree(1).size(); ++e)
        for (int i = 0; i <= 1; ++i)
            if (const Index v = ends(e, i);
                local_.owns(ranks_, 0, v) && blocks.active_cofaces[0][v] == 0)
                flaws.push_back({{carriers[1][e].dimension, carriers[1][e].first}, 0, 0, 1});
    return summed(std::move(flaws));
}

/// Summed up where the numbers of first pieces lie.
std::vector<BlockName> Rounds::bad_cells(const std::vector<Flaw>& flaws,
                                         const Carriers& carriers) const {
    auto parcels = ranks_.empty_parcels<Flaw>();
    for (const Flaw& flaw : flaws)
        parcels[rank_for(flaw.cell)].push_back(flaw);
    const auto arrived = ranks_.deliver(std::move(parcels));
    const auto known = ranks_.together("cells", [&] { return summed(unpacked(arrived)); });
    std::vector<BlockName> no_balls, undecided;
    for (const auto& [cell, euler, below_interfaces, is_amiss] : known)
        if (euler != 0 || is_amiss != 0)
            no_balls.push_back(cell);
        else if (below_interfaces > most_below_interfaces)
            undecided.push_back(cell);
    undecided = ranks_.of_all(undecided);
    std::sort(undecided.begin(), undecided.end());
    auto bad = ranks_.of_all(no_balls);
    const auto others = no_balls_among(undecided, carriers);
    bad.insert(bad.end(), others.begin(), others.end());
    std::sort(bad.begin(), bad.end());
    return bad;
}

/// Their interiors are gathered in the same places.
std::vector<BlockName> Rounds::no_balls_among(const std::vector<BlockName>& cells,
                                              const Carriers& carriers) const {
    auto parcels = ranks_.empty_parcels<OpenIncidence>();
    for (int k = 1; k <= n_ && !cells.empty(); ++k) {
        const auto &numbers = local_.degree(k).number, &of_faces = local_.degree(k - 1).number;
        for (Index s = 0; s < local_.degree(k).size(); ++s) {
            const BlockName cell{carriers[k][s].dimension, carriers[k][s].first};
            if (!local_.owns(ranks_, k, s) || !std::binary_search(cells.begin(), cells.end(), cell))
                continue;
            for (const auto& [face, sign] : local_.complex.incidences(k - 1)[s])
                if (carriers[k - 1][face].dimension == cell.dimension)
                    parcels[rank_for(cell)].push_back({cell, k, numbers[s], of_faces[face], sign});
        }
    }
    const auto arrived = ranks_.deliver(std::move(parcels));
    return ranks_.of_all(
        ranks_.together("cells", [&] { return without_homology_of_balls(unpacked(arrived)); }));
}

/// As one process does: see merge_cospherical.
void Rounds::keep_worst(const std::vector<BlockName>& bad, const Carriers& carriers) {
    std::vector<double> worst(bad.size(), 0);
    const auto for_each_interface = [&](auto take) {
        for (int k = 0; k < n_; ++k)
            for (Index s = 0; s < local_.degree(k).size(); ++s) {
                const auto& [dimension, sign, owner, first] = carriers[k][s];
                const BlockName cell{dimension, first};
                const auto found = std::lower_bound(bad.begin(), bad.end(), cell);
                if (dimension == k + 1 && local_.owns(ranks_, k, s) && found != bad.end() &&
                    *found == cell)
                    take(k, s, worst[found - bad.begin()]);
            }
    };
    for_each_interface([&](int k, Index s, double& of_cell) {
        if (k == n_ - 1)
            of_cell = std::max(of_cell, defects_.ratio(s));
    });
    ranks_.take_largest(worst);
    for_each_interface([&](int k, Index s, double of_cell) {
        if (k < n_ - 1 || is_among_the_worst(defects_.ratio(s), of_cell))
            kept_[k][s] = 1;
    });
    for (int k = 0; k < n_; ++k)
        refresh(ranks_, local_.degree(k).copies, kept_[k]);
}

/// Every simplex its own cell.
DistributedMerging Rounds::unmerged(DistributedMerging result) const {
    for (int k = 0; k <= n_; ++k) {
        const auto& degree = local_.degree(k);
        auto& own = result.carriers.emplace_back();
        own.reserve(degree.number.size());
        for (Index s = 0; s < degree.size(); ++s)
            own.push_back({static_cast<std::int8_t>(k), 1, degree.owner[s], degree.number[s]});
    }
    return result;
}

DistributedMerging Rounds::run() {
    const auto& degenerate = defects_.degenerate;
    DistributedMerging result{{},
                              volumes_,
                              {},
                              0,
                              true,
                              ranks_.sum(degenerate.interior),
                              ranks_.sum(degenerate.boundary),
                              ranks_.sum(degenerate.branching),
                              degenerate.marks};
    const bool any_flat = ranks_.any(!defects_.flat.empty());
    if (options_.criterion == MergeCriterion::none ||
        (result.degenerate_interior == 0 && !any_flat))
        return unmerged(std::move(result));
    const bool is_in_space = local_.points.cols() == n_;
    for (;; ++result.rounds) {
        const auto classes =
            join_facets(ranks_, local_, volumes_, defects_, options_.tolerance, kept_[n_ - 1]);
        if (!classes.any)
            return unmerged(std::move(result));
        CellVolumes of_pieces = volumes_;
        Centers centers;
        if (is_in_space && !classes.exact) {
            centers = shared_centers(ranks_, local_, volumes_, classes, defects_.flat);
            of_pieces = ranks_.together(
                "volumes", [&] { return dual_volumes(local_.complex, local_.points, centers); });
        }
        const Blocks blocks = ranks_.together("blocks", [&] { return join(classes, of_pieces); });
        Carriers carriers = carriers_of(blocks);
        const auto flaws = ranks_.together("cells", [&] { return local_flaws(blocks, carriers); });
        const auto bad = bad_cells(flaws, carriers);
        if (bad.empty()) {
            result.carriers = std::move(carriers);
            result.of_pieces = of_pieces;
            result.centers = centers;
            result.is_identity = false;
            return result;
        }
        keep_worst(bad, carriers);
    }
}

} // namespace

DistributedMerging merge_cospherical(const Ranks& ranks, const LocalComplex& local,
                                     const CellVolumes& volumes, const MergeOptions& options) {
    ranks.together("merge", [&] { check_not_negative("the merge tolerance", options.tolerance); });
    return Rounds(ranks, local, volumes, options).run();
}

} // namespace polydec
