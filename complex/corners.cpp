// SPDX-License-Identifier: MIT
#include "base/checks.h"
#include "base/errors.h"
#include "complex/merging.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace polydec {

namespace {

/// A side of a triangle, directed as the boundary of the merged cell runs. The three sides of a
/// triangle are neighbors in the list and follow each other around it.
struct HalfEdge {
    Index edge, tail, head;
    Index twin = -1; // the other side of a removed edge
};

std::vector<HalfEdge> half_edges(const Merging& merging, Index cell) {
    const auto& K = merging.pieces();
    std::vector<HalfEdge> sides;
    for (IncidenceMatrix::InnerIterator piece(merging.diamond(2), cell); piece; ++piece) {
        const auto around = K.incidences(1)[static_cast<Index>(piece.col())];
        const bool is_forward = piece.value() * around[0].sign > 0;
        for (const Index place : {0, is_forward ? 2 : 1, is_forward ? 1 : 2}) {
            const auto [edge, sign] = around[place];
            const auto ends = K.simplices(1).row(edge);
            const bool ascending = piece.value() * sign > 0;
            sides.push_back({edge, ends[ascending ? 0 : 1], ends[ascending ? 1 : 0]});
        }
    }
    return sides;
}

void link_twins(const Merging& merging, std::vector<HalfEdge>& sides) {
    std::vector<std::pair<Index, Index>> removed; // edge, side
    for (std::size_t h = 0; h < sides.size(); ++h)
        if (merging.carriers(1)[sides[h].edge].dimension > 1)
            removed.emplace_back(sides[h].edge, static_cast<Index>(h));
    std::sort(removed.begin(), removed.end());
    for (std::size_t i = 0; i + 1 < removed.size(); i += 2) {
        sides[removed[i].second].twin = removed[i + 1].second;
        sides[removed[i + 1].second].twin = removed[i].second;
    }
}

/// The side that follows in the same triangle, whose vertices need not differ.
Index follower(Index side) {
    return side % 3 == 2 ? side - 2 : side + 1;
}

} // namespace

std::vector<Index> corners(const Merging& merging, Index cell) {
    check_number("2-cell", cell, 0, merging.diamond(2).rows() - 1);
    auto sides = half_edges(merging, cell);
    link_twins(merging, sides);

    Index start = -1;
    for (std::size_t h = 0; h < sides.size(); ++h)
        if (sides[h].twin < 0 && (start < 0 || sides[h].edge < sides[start].edge))
            start = static_cast<Index>(h);

    // around the boundary; at each corner the fan of triangles is crossed to the next kept edge
    std::vector<Index> walk;
    Index side = start;
    do {
        walk.push_back(sides[side].tail);
        side = follower(side);
        while (sides[side].twin >= 0)
            side = follower(sides[side].twin);
    } while (side != start && walk.size() <= sides.size());
    return walk;
}

std::vector<Index> corners(const CellComplex& complex, Index cell) {
    const Incidences& sides = complex.incidences(1);
    check_number("2-cell", cell, 0, sides.rows() - 1);
    std::vector<std::pair<Index, Index>> ways; // tail, head, by tails
    Index walk_from = -1;
    for (const auto& [side, direction] : sides[cell]) {
        std::array<Index, 2> ends{-1, -1};
        for (const auto& [end, sign] : complex.incidences(0)[side])
            ends[sign * direction > 0 ? 1 : 0] = end;
        ways.emplace_back(ends[0], ends[1]);
        walk_from = walk_from < 0 ? ends[0] : walk_from;
    }
    std::sort(ways.begin(), ways.end());
    std::vector<Index> walk;
    Index v = walk_from;
    while (v >= 0 && walk.size() < ways.size() && (walk.empty() || v != walk_from)) {
        walk.push_back(v);
        const auto way = std::lower_bound(ways.begin(), ways.end(), std::pair{v, Index{-1}});
        v = way != ways.end() && way->first == v ? way->second : -1;
    }
    if (walk.empty() || walk.size() < ways.size() || v != walk_from)
        throw InvalidInput(fmt::format("the boundary of 2-cell {} is not a single closed path, so "
                                       "its corners have no order",
                                       cell),
                           {.degree = 2, .cells = {cell}});
    return walk;
}

} // namespace polydec
