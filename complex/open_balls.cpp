// SPDX-License-Identifier: MIT
#include "complex/open_balls.h"

#include "base/lists.h"
#include "complex/homology.h"

#include <algorithm>
#include <span>
#include <utility>

namespace polydec {

namespace {

/// The open simplices of a block with the incidences between them.
CellComplex interior(std::span<const OpenIncidence> block) {
    const auto d = static_cast<std::size_t>(block.front().block.dimension);
    std::vector<std::vector<std::int64_t>> cells(d + 1);
    for (const OpenIncidence& at : block) {
        cells[at.k].push_back(at.simplex);
        cells[at.k - 1].push_back(at.face);
    }
    for (auto& of_degree : cells)
        sort_unique(of_degree);
    std::vector<std::vector<Eigen::Triplet<std::int8_t, Index>>> entries(d);
    for (const OpenIncidence& at : block)
        entries[at.k - 1].emplace_back(place_in(cells[at.k], at.simplex),
                                       place_in(cells[at.k - 1], at.face),
                                       static_cast<std::int8_t>(at.sign));
    std::vector<Coboundary> coboundaries;
    for (std::size_t k = 0; k < d; ++k) {
        IncidenceMatrix D(std::ssize(cells[k + 1]), std::ssize(cells[k]));
        D.setFromTriplets(entries[k].begin(), entries[k].end());
        coboundaries.push_back({Incidences(std::move(D)), CofaceCounts(cells[k].size())});
    }
    return CellComplex(CellComplex::Unchecked{}, std::move(coboundaries));
}

} // namespace

std::vector<BlockName> without_homology_of_balls(std::vector<OpenIncidence> incidences) {
    std::sort(incidences.begin(), incidences.end(),
              [](const OpenIncidence& a, const OpenIncidence& b) { return a.block < b.block; });
    std::vector<BlockName> result;
    for (auto begin = incidences.begin(); begin != incidences.end();) {
        const BlockName block = begin->block;
        const auto end = std::find_if(begin, incidences.end(),
                                      [&](const OpenIncidence& at) { return at.block != block; });
        std::vector<Index> of_ball(static_cast<std::size_t>(block.dimension) + 1, 0);
        of_ball.back() = 1;
        if (betti_numbers(interior({begin, end})) != of_ball)
            result.push_back(block);
        begin = end;
    }
    return result;
}

} // namespace polydec
