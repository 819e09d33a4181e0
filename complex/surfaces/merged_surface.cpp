// SPDX-License-Identifier: MIT
#include "complex/surfaces/merged_surface.h"

#include "base/checks.h"
#include "complex/disjoint_sets.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace polydec {

namespace {

using Row = IncidenceMatrix::InnerIterator;

/// Which edges go, and the triangles joined across them.
struct Removal {
    DisjointSets polygons;
    std::vector<bool> removed;
};

Removal remove_edges(const GluedSurface& surface, std::span<const Index> edges) {
    Removal result{DisjointSets(surface.triangles()),
                   std::vector<bool>(static_cast<std::size_t>(surface.edges()), false)};
    for (const Index e : edges) {
        check_number("edge", e, 0, surface.edges() - 1);
        if (surface.is_boundary(e))
            continue;
        const auto& [h, g] = surface.halfedges(e);
        const Index t = GluedSurface::triangle(h), u = GluedSurface::triangle(g);
        if (result.polygons.find(t).element == result.polygons.find(u).element)
            continue;
        result.polygons.join(t, u, surface.is_coherent(e) ? 1 : -1);
        result.removed[e] = true;
    }
    return result;
}

/// One piece in a row each, for the cells that are kept.
IncidenceMatrix kept_cells(const std::vector<bool>& removed) {
    const auto pieces = static_cast<Index>(removed.size());
    const auto cells = static_cast<Index>(std::count(removed.begin(), removed.end(), false));
    IncidenceMatrix diamond(cells, pieces);
    diamond.resizeNonZeros(cells);
    Index row = 0;
    for (Index s = 0; s < pieces; ++s)
        if (!removed[s]) {
            diamond.innerIndexPtr()[row] = s;
            diamond.valuePtr()[row] = 1;
            ++row;
            diamond.outerIndexPtr()[row] = row;
        }
    return diamond;
}

/// The triangles of each polygon, ascending, with their signs.
IncidenceMatrix polygons(DisjointSets& sets, Index triangles) {
    std::vector<Index> number(static_cast<std::size_t>(triangles), -1), cell(number.size());
    std::vector<std::int8_t> sign(number.size()), first_sign;
    std::vector<Index> ends{0};
    for (Index t = 0; t < triangles; ++t) {
        const auto root = sets.find(t);
        Index& own = number[root.element];
        if (own < 0) {
            own = static_cast<Index>(first_sign.size());
            first_sign.push_back(root.sign);
            ends.push_back(0);
        }
        cell[t] = own;
        sign[t] = static_cast<std::int8_t>(root.sign * first_sign[own]);
        ++ends[own + 1];
    }
    std::partial_sum(ends.begin(), ends.end(), ends.begin());
    IncidenceMatrix diamond(static_cast<Index>(first_sign.size()), triangles);
    diamond.resizeNonZeros(triangles);
    std::copy(ends.begin(), ends.end(), diamond.outerIndexPtr());
    for (Index t = 0; t < triangles; ++t) {
        const Index place = ends[cell[t]]++;
        diamond.innerIndexPtr()[place] = t;
        diamond.valuePtr()[place] = sign[t];
    }
    return diamond;
}

struct Sides {
    IncidenceMatrix coboundary;
    std::vector<Index> counts; // of the polygons around each edge
    std::vector<Incidence> canceled;
};

/// d_1 of the polygons: the sides of their triangles that are kept; a polygon on both sides of an
/// edge cancels there.
Sides sides_of_polygons(const GluedSurface& surface, const IncidenceMatrix& pieces,
                        const std::vector<bool>& removed) {
    std::vector<Index> number(removed.size());
    Index edges = 0;
    for (std::size_t e = 0; e < removed.size(); ++e)
        number[e] = removed[e] ? -1 : edges++;

    Sides result{IncidenceMatrix(pieces.rows(), edges),
                 std::vector<Index>(static_cast<std::size_t>(edges), 0),
                 {}};
    auto& d = result.coboundary;
    d.resizeNonZeros(3 * pieces.cols());
    Index entries = 0;
    std::vector<std::pair<Index, int>> sides;
    for (Index cell = 0; cell < pieces.rows(); ++cell) {
        sides.clear();
        for (Row piece(pieces, cell); piece; ++piece)
            for (Index h = 3 * static_cast<Index>(piece.col()), i = 0; i < 3; ++i)
                if (const Index e = number[surface.edge(h + i)]; e >= 0) {
                    sides.emplace_back(e, piece.value() * surface.sign(h + i));
                    ++result.counts[e];
                }
        std::sort(sides.begin(), sides.end());
        for (std::size_t i = 0, j = 0; i < sides.size(); i = j) {
            int sum = 0;
            for (; j < sides.size() && sides[j].first == sides[i].first; ++j)
                sum += sides[j].second;
            if (sum == 0) {
                result.canceled.push_back({cell, sides[i].first});
                continue;
            }
            d.innerIndexPtr()[entries] = sides[i].first;
            d.valuePtr()[entries++] = static_cast<std::int8_t>(sum);
        }
        d.outerIndexPtr()[cell + 1] = entries;
    }
    d.resizeNonZeros(entries);
    return result;
}

/// d_0 for the edges that are kept; a loop has an empty row and is noted.
IncidenceMatrix ends_of_edges(const GluedSurface& surface, const std::vector<bool>& removed,
                              Index rows, std::vector<Incidence>& loops) {
    IncidenceMatrix d(rows, surface.vertices());
    d.resizeNonZeros(2 * Eigen::Index(rows));
    Index row = 0, entries = 0;
    for (Index e = 0; e < surface.edges(); ++e) {
        if (removed[e])
            continue;
        const Index a = surface.first_vertex(e), b = surface.last_vertex(e);
        if (a != b) {
            d.innerIndexPtr()[entries] = std::min(a, b);
            d.valuePtr()[entries++] = static_cast<std::int8_t>(a < b ? -1 : 1);
            d.innerIndexPtr()[entries] = std::max(a, b);
            d.valuePtr()[entries++] = static_cast<std::int8_t>(a < b ? 1 : -1);
        } else {
            loops.push_back({row, a});
        }
        d.outerIndexPtr()[++row] = entries;
    }
    d.resizeNonZeros(entries);
    return d;
}

/// How many of the kept edges begin or end at each vertex, loops counting twice.
std::vector<Index> kept_edges_at_vertices(const GluedSurface& surface,
                                          const std::vector<bool>& removed) {
    std::vector<Index> counts(static_cast<std::size_t>(surface.vertices()), 0);
    for (Index e = 0; e < surface.edges(); ++e)
        if (!removed[e])
            ++counts[surface.first_vertex(e)], ++counts[surface.last_vertex(e)];
    return counts;
}

} // namespace

MergedSurface merge_triangles(const GluedSurface& surface, std::span<const Index> edges) {
    Removal removal = remove_edges(surface, edges);
    std::vector<IncidenceMatrix> diamonds(3), d(2);
    kept_cells(std::vector<bool>(static_cast<std::size_t>(surface.vertices()), false))
        .swap(diamonds[0]);
    kept_cells(removal.removed).swap(diamonds[1]);
    polygons(removal.polygons, surface.triangles()).swap(diamonds[2]);

    auto sides = sides_of_polygons(surface, diamonds[2], removal.removed);
    const auto edges_left = static_cast<Index>(diamonds[1].rows());
    std::vector<Incidence> loops;
    ends_of_edges(surface, removal.removed, edges_left, loops).swap(d[0]);
    d[1].swap(sides.coboundary);
    CellComplex merged(CellComplex::Unchecked{}, std::move(d),
                       {kept_edges_at_vertices(surface, removal.removed), std::move(sides.counts)},
                       {std::move(loops), std::move(sides.canceled)});
    return {std::move(merged), std::move(diamonds)};
}

CellComplex cell_complex(const GluedSurface& surface) {
    return merge_triangles(surface, {}).merged;
}

std::vector<Index> vertices(const GluedSurface& surface, const MergedSurface& merging, int k,
                            Index cell) {
    check_number("a cell of degree", k, 0, 2);
    check_number(fmt::format("{}-cell", k), cell, 0, merging.diamonds[k].rows() - 1);
    std::vector<Index> list;
    for (Row piece(merging.diamonds[k], cell); piece; ++piece) {
        const auto s = static_cast<Index>(piece.col());
        if (k == 0)
            list.push_back(s);
        else if (k == 1)
            list.insert(list.end(), {surface.first_vertex(s), surface.last_vertex(s)});
        else
            list.insert(list.end(),
                        {surface.tail(3 * s), surface.tail(3 * s + 1), surface.tail(3 * s + 2)});
    }
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
    return list;
}

} // namespace polydec
