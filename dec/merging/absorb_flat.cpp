// SPDX-License-Identifier: MIT
#include "dec/merging/absorb_flat.h"

#include "base/lists.h"
#include "dec/merging/facet_links.h"
#include "dec/merging/mean_spheres.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace polydec {

namespace {

/// The values, with values equal up to rounding replaced by the least of them.
std::vector<double> without_rounding(const std::vector<double>& values) {
    std::vector<double> least = values;
    std::sort(least.begin(), least.end());
    std::size_t kept = 0;
    for (const double value : least)
        if (kept == 0 || value > least[kept - 1] * (1 + tie))
            least[kept++] = value;
    least.resize(kept);
    std::vector<double> result;
    for (const double value : values)
        result.push_back(*std::prev(std::upper_bound(least.begin(), least.end(), value)));
    return result;
}

/// The flat simplices that classes of ordinary simplices may absorb.
class Absorption {
public:
    Absorption(const Geometry& geometry, const std::vector<bool>& flat, const AroundFlat& around,
               double tolerance, DisjointSets& classes)
        : complex_(geometry.pieces()),
          points_(*geometry.metric().points()),
          volumes_(geometry.volumes()),
          flat_(flat),
          around_(around),
          tolerance_(tolerance),
          classes_(classes),
          taken_(flat.size(), false),
          spheres_(geometry, flat) {}

    void run() {
        do
            find_candidates();
        while (unite_cut_classes());
        hand_over();
    }

private:
    int n() const { return complex_.dimension(); }

    /// The n-simplex behind facet i of t; -1 if there is none, or the facet must stay.
    Index behind(Index t, int i) const {
        const auto& [a, b] = around_.sides[complex_.face(n(), t, i)];
        return b < 0 ? -1 : a == t ? b : a;
    }

    bool lies_on(Index t, Index root) const {
        constexpr double rounding = 1e3 * std::numeric_limits<double>::epsilon();
        double edge = std::numeric_limits<double>::infinity(), distance = 0;
        for (const Index v : complex_.simplices(n()).row(t)) {
            edge = std::min(edge, around_.shortest[v]);
            distance = std::max(distance, spheres_.distance(root, v));
        }
        return distance <= tolerance_ * edge + rounding * spheres_.radius(root);
    }

    /// The classes beside a flat simplex on whose sphere it lies, and candidates of flat neighbors.
    void find_candidates() {
        roots_ = classes_.firsts();
        spheres_.gather(roots_);
        candidates_.clear();
        std::vector<std::pair<Index, Index>> found;
        const auto offer = [&](Index t, Index root) {
            auto& known = candidates_[t];
            if (std::find(known.begin(), known.end(), root) == known.end() && lies_on(t, root)) {
                known.push_back(root);
                found.emplace_back(t, root);
            }
        };
        for (Index t = 0; t < std::ssize(flat_); ++t)
            for (int i = 0; i <= n() && flat_[t]; ++i)
                if (const Index other = behind(t, i); other >= 0 && !flat_[other])
                    offer(t, roots_[other]);
        while (!found.empty()) {
            const auto [t, root] = found.back();
            found.pop_back();
            for (int i = 0; i <= n(); ++i)
                if (const Index other = behind(t, i); other >= 0 && flat_[other])
                    offer(other, root);
        }
    }

    bool unite_cut_classes() {
        bool any = false;
        for (const auto& [t, roots] : candidates_)
            for (std::size_t i = 0; i < roots.size(); ++i)
                for (std::size_t j = 0; j < i; ++j)
                    if (are_near(t, roots[i], roots[j])) {
                        classes_.join(roots[i], roots[j]);
                        any = true;
                    }
        return any;
    }

    /// Whether the centers of two classes are as close as across a degenerate facet.
    bool are_near(Index t, Index root, Index other) const {
        constexpr double thin = 0.1; // of a height
        double reach = std::numeric_limits<double>::infinity();
        bool has_neighbor = false;
        for (int i = 0; i <= n(); ++i) {
            const Index f = complex_.face(n(), t, i);
            reach = std::min(reach, tolerance_ * around_.sizes[f]);
            if (const Index s = behind(t, i); s >= 0 && !flat_[s]) {
                has_neighbor = true;
                reach = std::min(reach, thin * n() * volumes_.primal(n())[s] /
                                            volumes_.primal(n() - 1)[f]);
            }
        }
        return has_neighbor && spheres_.between(root, other) <= reach;
    }

    /// Gives each class in turn its remaining candidates that are connected to it.
    void hand_over() {
        std::map<Index, std::vector<Index>> by_root;
        for (const auto& [t, roots] : candidates_)
            for (const Index root : roots)
                by_root[root].push_back(t);
        for (const Index root : in_order_of_size())
            hand_over_to(root, by_root[root]);
    }

    void hand_over_to(Index root, const std::vector<Index>& simplices) {
        std::vector<Index> front;
        const auto take = [&](Index t) {
            if (taken_[t] || !std::binary_search(simplices.begin(), simplices.end(), t))
                return;
            taken_[t] = true;
            classes_.join(t, root);
            front.push_back(t);
        };
        for (const Index t : simplices)
            for (int i = 0; i <= n(); ++i)
                if (const Index other = behind(t, i);
                    other >= 0 && !flat_[other] && roots_[other] == root)
                    take(t);
        while (!front.empty()) {
            const Index t = front.back();
            front.pop_back();
            for (int i = 0; i <= n(); ++i)
                if (const Index other = behind(t, i); other >= 0 && flat_[other])
                    take(other);
        }
    }

    /// All candidates sorted by volume, then by the radius of their spheres, then, if both are
    /// equal up to rounding, by the ascending places of their corners. Only the classes that flat
    /// simplices may join are compared.
    std::vector<Index> in_order_of_size() const {
        std::map<Index, std::vector<Index>> corners;
        std::map<Index, double> volume;
        DisjointSets together(static_cast<Index>(roots_.size()));
        for (const auto& [t, roots] : candidates_)
            for (const Index root : roots) {
                corners[root];
                together.join(root, roots.front());
            }
        for (Index t = 0; t < std::ssize(roots_); ++t)
            if (const auto found = corners.find(roots_[t]); found != corners.end()) {
                const auto simplex = complex_.simplices(n()).row(t);
                found->second.insert(found->second.end(), simplex.begin(), simplex.end());
                volume[roots_[t]] += flat_[t] ? 0 : volumes_.primal(n())[t];
            }
        const auto before = [this](Index v, Index w) {
            const auto a = points_.row(v), b = points_.row(w);
            return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
        };
        std::map<Index, std::vector<Index>> parts;
        for (auto& [root, list] : corners) {
            sort_unique(list);
            std::sort(list.begin(), list.end(), before);
            parts[together.find(root).element].push_back(root);
        }
        std::vector<Index> result;
        for (const auto& part : parts) {
            const std::vector<Index>& roots = part.second;
            std::vector<double> volumes, radii;
            for (const Index root : roots) {
                volumes.push_back(volume[root]);
                radii.push_back(spheres_.radius(root));
            }
            volumes = without_rounding(volumes);
            radii = without_rounding(radii);
            std::vector<std::size_t> order(roots.size());
            std::iota(order.begin(), order.end(), std::size_t{0});
            std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
                if (volumes[i] != volumes[j])
                    return volumes[i] < volumes[j];
                if (radii[i] != radii[j])
                    return radii[i] < radii[j];
                return std::ranges::lexicographical_compare(corners.at(roots[i]),
                                                            corners.at(roots[j]), before);
            });
            for (const std::size_t i : order)
                result.push_back(roots[i]);
        }
        return result;
    }

    const Pieces& complex_;
    const Points& points_;
    const CellVolumes& volumes_;
    const std::vector<bool>& flat_;
    const AroundFlat& around_;
    double tolerance_;
    DisjointSets& classes_;
    std::vector<bool> taken_;
    MeanSpheres spheres_;
    std::vector<Index> roots_;                       // of all: the first of its class
    std::map<Index, std::vector<Index>> candidates_; // roots, per flat simplex
};

} // namespace

void absorb_flat(const Geometry& geometry, const std::vector<bool>& flat, const AroundFlat& around,
                 double tolerance, DisjointSets& classes) {
    Absorption(geometry, flat, around, tolerance, classes).run();
}

} // namespace polydec
