// SPDX-License-Identifier: MIT
#include "distributed/facet_classes.h"

#include "dec/merging/facet_links.h"
#include "dec/merging/flat_simplices.h"
#include "distributed/labels.h"
#include "distributed/number_places.h"
#include "distributed/shared_flat.h"

#include <algorithm>

namespace polydec {

namespace {

/// A facet between two n-simplices that may become one, by numbers.
struct SentLink {
    GlobalIndex facet, a, b;
    std::int32_t owner_of_a, owner_of_b;
    double defect, scale;
};

class FacetJoining {
public:
    FacetJoining(const Ranks& ranks, const LocalComplex& local, const CellVolumes& volumes,
                 const FacetDefects& defects, double tolerance,
                 const std::vector<std::uint8_t>& kept)
        : ranks_(ranks),
          local_(local),
          volumes_(volumes),
          defects_(defects),
          tolerance_(tolerance),
          kept_(kept),
          n_(local.dimension()),
          cofaces_(local.complex, n_) {}

    FacetClasses run() {
        const LocalClasses parts = ranks_.together("links", [&] { return parts_of(); });
        labels_ = spread_labels(ranks_, local_, n_, parts).of;
        const auto arrived = ranks_.deliver(ranks_.together("links", [&] { return links(); }));
        const auto found =
            ranks_.deliver(ranks_.together("classes", [&] { return classes_of(arrived); }));
        FacetClasses result{local_.degree(n_).number, {}};
        take_classes(ranks_, local_, found, result.first);
        if (ranks_.any(!defects_.flat.empty()))
            absorb_flat(ranks_, local_, volumes_, defects_, free_facets(), tolerance_,
                        result.first);
        read_off(result);
        return result;
    }

private:
    bool has_two_sides(Index f) const {
        return local_.degree(n_ - 1).complete[f] && cofaces_.of(f).size() == 2;
    }
    bool is_link(Index f) const {
        return has_two_sides(f) && defects_.degenerate[f] && kept_[f] == 0;
    }

    /// 1 for those between two n-simplices that may vanish, known for every facet here.
    std::vector<std::uint8_t> free_facets() const {
        std::vector<std::uint8_t> free;
        free.reserve(kept_.size());
        for (Index f = 0; f < local_.degree(n_ - 1).size(); ++f)
            free.push_back(has_two_sides(f) && kept_[f] == 0 ? 1 : 0);
        refresh(ranks_, local_.degree(n_ - 1).copies, free);
        return free;
    }

    LocalClasses parts_of() const {
        const Index size = local_.degree(n_).size();
        DisjointSets sets(size);
        for (Index f = 0; f < local_.degree(n_ - 1).size(); ++f)
            if (is_link(f))
                sets.join(cofaces_.of(f)[0].cell, cofaces_.of(f)[1].cell);
        return LocalClasses(sets.firsts());
    }

    Parcels<SentLink> links() const {
        auto parcels = ranks_.empty_parcels<SentLink>();
        const auto &facets = local_.degree(n_ - 1), &tops = local_.degree(n_);
        for (Index f = 0; f < facets.size(); ++f)
            if (is_link(f) && facets.owner[f] == ranks_.rank()) {
                const Index a = cofaces_.of(f)[0].cell, b = cofaces_.of(f)[1].cell;
                parcels[labels_[a].owner].push_back({facets.number[f], tops.number[a],
                                                     tops.number[b], tops.owner[a], tops.owner[b],
                                                     defects_.defect[f], defects_.scale[f]});
            }
        return parcels;
    }

    Parcels<SimplexClass> classes_of(const Parcels<SentLink>& arrived) const;
    void read_off(FacetClasses& classes) const;

    const Ranks& ranks_;
    const LocalComplex& local_;
    const CellVolumes& volumes_;
    const FacetDefects& defects_;
    double tolerance_;
    const std::vector<std::uint8_t>& kept_;
    int n_;
    Cofaces cofaces_;
    std::vector<Label> labels_; // of what hangs together
};

/// Links in the order of facets, as one process has them.
Parcels<SimplexClass> FacetJoining::classes_of(const Parcels<SentLink>& arrived) const {
    std::vector<SentLink> links = unpacked(arrived);
    const auto is_before = [](const SentLink& x, const SentLink& y) { return x.facet < y.facet; };
    if (!std::is_sorted(links.begin(), links.end(), is_before))
        std::sort(links.begin(), links.end(), is_before);
    std::vector<GlobalIndex> ends;
    ends.reserve(2 * links.size());
    for (const SentLink& link : links)
        ends.insert(ends.end(), {link.a, link.b});
    const NumberPlaces place(ends);
    const auto& simplices = place.numbers();
    std::vector<std::int32_t> owners(simplices.size());
    for (const SentLink& link : links) {
        owners[place(link.a)] = link.owner_of_a;
        owners[place(link.b)] = link.owner_of_b;
    }
    std::vector<FacetLink> by_place;
    by_place.reserve(links.size());
    for (const SentLink& link : links)
        by_place.push_back({place(link.a), place(link.b), link.defect, link.scale});
    DisjointSets classes(static_cast<Index>(simplices.size()));
    join_links(by_place, tolerance_, classes);
    auto parcels = ranks_.empty_parcels<SimplexClass>();
    const auto first = classes.firsts();
    for (std::size_t i = 0; i < simplices.size(); ++i)
        parcels[owners[i]].push_back({simplices[i], simplices[first[i]]});
    return parcels;
}

void FacetJoining::read_off(FacetClasses& classes) const {
    const bool is_in_space = local_.points.cols() == n_;
    const double limit = spread_limit * tolerance_;
    bool any = false, exact = true;
    classes.removed.assign(kept_.size(), 0);
    for (Index f = 0; f < local_.degree(n_ - 1).size(); ++f) {
        if (!has_two_sides(f) || kept_[f] != 0)
            continue;
        const auto sides = cofaces_.of(f);
        if (classes.first[sides[0].cell] != classes.first[sides[1].cell] ||
            !(is_in_space || defects_.defect[f] <= limit * defects_.scale[f]))
            continue;
        classes.removed[f] = 1;
        any = true;
        const auto& flat = defects_.flat;
        exact = exact && defects_.defect[f] == 0 &&
                (flat.empty() || (!flat[sides[0].cell] && !flat[sides[1].cell]));
    }
    refresh(ranks_, local_.degree(n_ - 1).copies, classes.removed);
    classes.any = ranks_.any(any);
    classes.exact = !ranks_.any(!exact);
}

} // namespace

void take_classes(const Ranks& ranks, const LocalComplex& local, const Parcels<SimplexClass>& found,
                  std::vector<GlobalIndex>& first) {
    const auto& tops = local.degrees.back();
    const NumberPlaces here(tops.number);
    for (const auto& parcel : found)
        for (const auto& [simplex, of_class] : parcel)
            first[here(simplex)] = of_class;
    refresh(ranks, tops.copies, first);
}

Vector shortest_edges(const Ranks& ranks, const LocalComplex& local, const CellVolumes& volumes) {
    std::vector<double> shortest = ranks.together("edges", [&] {
        const Vector edges = shortest_edges(local.complex, volumes);
        return std::vector<double>(edges.begin(), edges.end());
    });
    refresh(ranks, local.degree(0).copies, shortest);
    return Eigen::Map<const Vector>(shortest.data(), std::ssize(shortest));
}

FacetDefects measure_facets(const Ranks& ranks, const LocalComplex& local,
                            const CellVolumes& volumes, const MergeOptions& options) {
    const int n = local.dimension();
    const Vector shortest = shortest_edges(ranks, local, volumes);
    FacetDefects defects = ranks.together("defects", [&] {
        const Geometry geometry(local.complex, local.points, volumes);
        auto flat = options.criterion == MergeCriterion::angle ? std::vector<bool>()
                                                               : flat_simplices(geometry, shortest);
        return facet_defects(geometry, options, std::move(flat));
    });
    struct Measure {
        double defect, scale;
        bool is_degenerate;
    };
    std::vector<Measure> measures;
    measures.reserve(defects.defect.size());
    auto& [interior, boundary, branching, marks] = defects.degenerate;
    for (Eigen::Index f = 0; f < defects.defect.size(); ++f)
        measures.push_back({defects.defect[f], defects.scale[f], marks[f]});
    refresh(ranks, local.degree(n - 1).copies, measures);
    interior = boundary = branching = 0;
    for (Index f = 0; f < local.degree(n - 1).size(); ++f) {
        defects.defect[f] = measures[f].defect;
        marks[f] = measures[f].is_degenerate;
        const Index around = local.complex.coface_counts(n - 1)[f];
        if (marks[f] && local.owns(ranks, n - 1, f))
            ++(around == 1 ? boundary : around == 2 ? interior : branching);
    }
    return defects;
}

FacetClasses join_facets(const Ranks& ranks, const LocalComplex& local, const CellVolumes& volumes,
                         const FacetDefects& defects, double tolerance,
                         const std::vector<std::uint8_t>& kept) {
    return FacetJoining(ranks, local, volumes, defects, tolerance, kept).run();
}

} // namespace polydec
