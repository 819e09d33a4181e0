// SPDX-License-Identifier: MIT
#include "dec/merging/facet_links.h"

#include "base/groups.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace polydec {

namespace {

/// Joins links with nonzero defect.
class LinkJoining {
public:
    LinkJoining(std::span<const FacetLink> links, double tolerance, DisjointSets& classes)
        : links_(links),
          limit_(spread_limit * tolerance),
          classes_(classes),
          parts_(classes),
          spread_(classes.size(), 0.0),
          place_(classes.size(), -1) {
        for (const FacetLink& link : links)
            parts_.join(link.a, link.b, link.relative_sign);
    }

    /// Most links are exact: only the others are sorted.
    void run() {
        const auto parts = static_cast<Index>(place_.size());
        const Groups inexact(static_cast<Index>(links_.size()), parts, [this](Index link) {
            return links_[link].defect > 0 ? parts_.find(links_[link].a).element : -1;
        });
        for (Index part = 0; part < parts; ++part)
            join_part({inexact[part].begin(), inexact[part].end()});
    }

private:
    double ratio(Index link) const { return links_[link].defect / links_[link].scale; }

    /// Ties are measured from the first of a group, so close values do not chain.
    void join_part(std::vector<Index> part) {
        std::stable_sort(part.begin(), part.end(),
                         [this](Index i, Index j) { return ratio(i) < ratio(j); });
        for (std::size_t begin = 0, end = 0; begin < part.size(); begin = end) {
            const double reach = ratio(part[begin]) + tie;
            while (end < part.size() && ratio(part[end]) <= reach)
                ++end;
            join_tied(std::span(part).subspan(begin, end - begin));
        }
    }

    /// Connected ties are joined all or none: their order must not matter.
    void join_tied(std::span<const Index> tied) {
        sides_.clear();
        roots_.clear();
        for (const Index i : tied)
            if (classes_.find(links_[i].a).element != classes_.find(links_[i].b).element) {
                const Index place_of_a = place_of(links_[i].a);
                sides_.push_back({i, place_of_a, place_of(links_[i].b)});
            }
        for (const Index root : roots_)
            place_[root] = -1;
        DisjointSets groups(static_cast<Index>(roots_.size()));
        for (const Sides& sides : sides_)
            groups.join(sides.a, sides.b);

        std::vector<double> gathered(roots_.size(), 0.0);
        std::vector<double> allowed(roots_.size(), std::numeric_limits<double>::infinity());
        for (std::size_t i = 0; i < roots_.size(); ++i)
            gathered[groups.find(static_cast<Index>(i)).element] += spread_[roots_[i]];
        for (const Sides& sides : sides_) {
            const Index group = groups.find(sides.a).element;
            gathered[group] += links_[sides.link].defect;
            allowed[group] = std::min(allowed[group], limit_ * links_[sides.link].scale);
        }
        for (const Sides& sides : sides_) {
            const Index group = groups.find(sides.a).element;
            if (gathered[group] > allowed[group])
                continue;
            const FacetLink& link = links_[sides.link];
            classes_.join(link.a, link.b, link.relative_sign);
            spread_[classes_.find(roots_[sides.a]).element] = gathered[group];
        }
    }

    Index place_of(Index simplex) {
        const Index root = classes_.find(simplex).element;
        if (place_[root] < 0) {
            place_[root] = static_cast<Index>(roots_.size());
            roots_.push_back(root);
        }
        return place_[root];
    }

    struct Sides {
        Index link, a, b; // classes on both sides, by position in `roots_`
    };

    std::span<const FacetLink> links_;
    double limit_;
    DisjointSets &classes_, parts_; // parts: connected by links
    std::vector<double> spread_;    // accumulated defect of each class, at its root
    std::vector<Index> place_;      // in `roots_`; -1 except while links are joined
    std::vector<Index> roots_;
    std::vector<Sides> sides_;
};

} // namespace

void join_links(std::span<const FacetLink> links, double tolerance, DisjointSets& classes) {
    bool are_exact = true;
    for (const FacetLink& link : links)
        if (link.defect > 0)
            are_exact = false;
        else
            classes.join(link.a, link.b, link.relative_sign);
    if (!are_exact)
        LinkJoining(links, tolerance, classes).run();
}

} // namespace polydec
