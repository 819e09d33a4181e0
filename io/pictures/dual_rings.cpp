// SPDX-License-Identifier: MIT
#include "io/pictures/dual_rings.h"

#include "base/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace polydec {

namespace {

/// A 2-cell at a vertex, with the two edges there: its boundary arrives along the first, and leaves
/// along the second.
struct Wedge {
    Index cell, arriving, leaving;
};

std::vector<Wedge> wedges_at(const Discretization& mesh, Index vertex) {
    const CellComplex& complex = mesh.complex();
    std::vector<Wedge> wedges;
    for (Index cell = 0; cell < complex.size(2); ++cell) {
        std::vector<Index> arriving, leaving;
        for (const auto& [edge, side] : complex.incidences(1)[cell])
            for (const auto& [end, sign] : complex.incidences(0)[edge])
                if (end == vertex)
                    (side * sign > 0 ? arriving : leaving).push_back(edge);
        if (arriving.size() != leaving.size() || arriving.size() > 1)
            throw InvalidInput(fmt::format("{} passes {} more than once: its dual cell is no "
                                           "polygon; choose another vertex",
                                           mesh.name(2, cell), mesh.name(0, vertex)),
                               {.degree = 2, .cells = {cell}});
        if (!arriving.empty())
            wedges.push_back({cell, arriving.front(), leaving.front()});
    }
    return wedges;
}

/// The wedges behind each edge at the vertex.
std::map<Index, std::vector<std::size_t>> by_edge(const Discretization& mesh,
                                                  const std::vector<Wedge>& wedges) {
    std::map<Index, std::vector<std::size_t>> result;
    for (std::size_t i = 0; i < wedges.size(); ++i)
        for (const Index edge : {wedges[i].arriving, wedges[i].leaving})
            result[edge].push_back(i);
    for (const auto& [edge, around] : result)
        if (around.size() > 2)
            throw InvalidInput(fmt::format("{} cells meet at {}: a dual cell there is no polygon; "
                                           "choose another vertex",
                                           around.size(), mesh.name(1, edge)),
                               {.degree = 1, .cells = {edge}});
    return result;
}

/// From a vertex of a chain to the middle of each edge there.
std::vector<std::vector<DualCorner>> halves_at(const CellComplex& complex, Index vertex) {
    std::vector<std::vector<DualCorner>> halves;
    for (Index edge = 0; edge < complex.size(1); ++edge)
        for (const auto& [end, sign] : complex.incidences(0)[edge])
            if (end == vertex)
                halves.push_back({{0, vertex}, {1, edge}});
    return halves;
}

} // namespace

std::vector<std::vector<DualCorner>> dual_rings(const Discretization& mesh, Index vertex) {
    if (mesh.dimension() == 1)
        return halves_at(mesh.complex(), vertex);
    const auto wedges = wedges_at(mesh, vertex);
    const auto around = by_edge(mesh, wedges);
    std::vector<bool> passed(wedges.size(), false);
    std::vector<std::vector<DualCorner>> rings;

    // counterclockwise where the cells are: from the edge along which a cell's boundary leaves
    const auto walk = [&](std::size_t i, Index edge) {
        std::vector<DualCorner> ring;
        const Index first = edge;
        for (bool open = true; open;) {
            passed[i] = true;
            ring.push_back({1, edge});
            ring.push_back({2, wedges[i].cell});
            edge = edge == wedges[i].leaving ? wedges[i].arriving : wedges[i].leaving;
            open = false;
            for (const std::size_t next : around.at(edge))
                if (!passed[next]) {
                    i = next;
                    open = true;
                }
        }
        if (edge != first) {
            ring.push_back({1, edge});
            ring.push_back({0, vertex});
        }
        rings.push_back(std::move(ring));
    };
    const auto is_rim = [&](Index edge) { return around.at(edge).size() == 1; };
    for (std::size_t i = 0; i < wedges.size(); ++i)
        if (!passed[i] && is_rim(wedges[i].leaving))
            walk(i, wedges[i].leaving);
    for (std::size_t i = 0; i < wedges.size(); ++i)
        if (!passed[i] && is_rim(wedges[i].arriving)) // cells that are not oriented alike
            walk(i, wedges[i].arriving);
    for (std::size_t i = 0; i < wedges.size(); ++i)
        if (!passed[i])
            walk(i, wedges[i].leaving);
    return rings;
}

} // namespace polydec
