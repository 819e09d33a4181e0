// SPDX-License-Identifier: MIT
#include "complex/coreduction.h"

#include "complex/disjoint_sets.h"

#include <algorithm>
#include <cstdlib>

namespace polydec {

Coreduction::Coreduction(const CellComplex& complex) : complex_(complex) {
    const int n = complex.dimension();
    pairs_.resize(n + 2);
    cofaces_.resize(n + 1);
    for (int k = 0; k <= n; ++k) {
        alive_.emplace_back(complex.size(k), true);
        complex.boundary(k + 1).swap(cofaces_[k]); // Eigen's matrices cannot be moved
        auto& count = faces_left_.emplace_back(complex.size(k), 0);
        for (Index t = 0; t < complex.size(k); ++t)
            count[t] = complex.incidences(k - 1)[t].size();
    }
    remove_base_vertices();
    for (int k = 1; k <= n; ++k) {
        pairs_[k].reserve(static_cast<std::size_t>(std::min(complex.size(k - 1), complex.size(k))));
        for (Index t = 0; t < complex.size(k); ++t)
            if (faces_left_[k][t] == 1)
                queue_.emplace_back(k, t);
    }
    while (!queue_.empty()) {
        const auto [k, t] = queue_.front();
        queue_.pop_front();
        pair_with_last_face(k, t);
    }
    cofaces_.clear();
}

/// One vertex of each component with a 0-cocycle stands for it. A component has none if an edge
/// has one end only, as in a complex relative to its boundary, or if signs clash around a loop.
void Coreduction::remove_base_vertices() {
    const Incidences& D = complex_.incidences(0);
    DisjointSets parts(complex_.size(0));
    std::vector<Index> without_cocycle;
    for (Index e = 0; e < D.rows(); ++e) {
        const IncidenceRow ends = D[e];
        if (ends.size() != 2 || std::abs(ends[0].sign) != std::abs(ends[1].sign)) {
            for (const SignedFace& v : ends)
                without_cocycle.push_back(v.face);
            continue;
        }
        const int relative_sign = ends[0].sign == ends[1].sign ? -1 : 1;
        if (!parts.join(ends[0].face, ends[1].face, relative_sign))
            without_cocycle.push_back(ends[0].face);
    }

    std::vector<bool> done(complex_.size(0), false); // at roots
    for (const Index v : without_cocycle)
        done[parts.find(v).element] = true;
    for (Index v = 0; v < complex_.size(0); ++v) {
        const auto root = parts.find(v).element;
        if (done[root])
            continue;
        done[root] = true;
        base_vertices_.push_back(v);
        remove(0, v);
    }
}

void Coreduction::remove(int k, Index s) {
    alive_[k][s] = false;
    for (IncidenceMatrix::InnerIterator t(cofaces_[k], s); t; ++t) {
        const auto cell = static_cast<Index>(t.col());
        if (--faces_left_[k + 1][cell] == 1)
            queue_.emplace_back(k + 1, cell);
    }
}

void Coreduction::pair_with_last_face(int k, Index t) {
    if (!alive_[k][t] || faces_left_[k][t] != 1)
        return;
    for (const auto& [face, sign] : complex_.incidences(k - 1)[t]) {
        // only an incidence that is invertible over the integers may cancel
        if (!alive_[k - 1][face] || std::abs(sign) != 1)
            continue;
        pairs_[k].push_back({face, t});
        remove(k - 1, face);
        remove(k, t);
        return;
    }
}

} // namespace polydec
