// SPDX-License-Identifier: MIT
#pragma once

#include "complex/cell_complex.h"

#include <deque>
#include <utility>

namespace polydec {

/// Simplifies a complex without changing its homology: starting from one vertex of each component,
/// a cell that is the only remaining face of another is removed together with it. The remaining
/// core is usually a handful of cells. On a closed surface the pairs are a spanning tree of edges
/// and a cotree of faces. Linear time. Source: Mrozek and Batko 2009.
class Coreduction {
public:
    explicit Coreduction(const CellComplex& complex);

    /// A removed pair: a k-cell `face` and a (k+1)-cell `coface` whose only remaining face it was.
    struct Pair {
        Index face, coface;
    };

    /// The pairs of k-cells with (k+1)-cells in the order of removal; none for k = -1, n.
    const std::vector<Pair>& pairs(int k) const { return pairs_.at(k + 1); }

    /// The starting vertices of the components that have a 0-cocycle.
    const std::vector<Index>& base_vertices() const { return base_vertices_; }

    /// Whether each k-cell belongs to the core.
    const std::vector<bool>& core(int k) const { return alive_.at(k); }

private:
    void remove_base_vertices();
    void remove(int k, Index s);
    void pair_with_last_face(int k, Index t);

    const CellComplex& complex_;
    std::vector<Index> base_vertices_;
    std::vector<std::vector<Pair>> pairs_; // at k + 1: of k-cells
    std::vector<std::vector<bool>> alive_;
    std::vector<std::vector<Index>> faces_left_;
    std::vector<IncidenceMatrix> cofaces_;
    std::deque<std::pair<int, Index>> queue_;
};

} // namespace polydec
