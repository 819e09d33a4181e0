// SPDX-License-Identifier: MIT
#include "io/meshes/cell_lists.h"

#include "base/listed.h"
#include "base/lists.h"
#include "io/meshes/readers.h"
#include "meshes/split_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace polydec {

void CellLists::add(int dimension, std::span<const Index> corners, Index tag) {
    auto& cells = lists_[dimension].cells;
    cells.add(corners);
    cells.tags.push_back(tag);
}

std::vector<Index> CellLists::tags_from(const std::vector<double>& numbers, std::size_t cells) {
    const auto other = std::find_if_not(numbers.begin(), numbers.end(), [](double number) {
        return number == std::floor(number) && number >= -0x1p31 && number < 0x1p31;
    });
    if (numbers.size() == cells && other == numbers.end())
        return {numbers.begin(), numbers.end()};
    warnings_.push_back(
        fmt::format("left out the groups of {}: {}", counted(cells, "cell", "cells"),
                    other == numbers.end() ? fmt::format("there are {} numbers", numbers.size())
                                           : fmt::format("{} is not a 32-bit integer", *other)));
    return std::vector<Index>(cells, 0);
}

/// Cells of smaller dimension mostly bound those of the mesh. Others would be missed.
std::vector<std::string> CellLists::warnings_of_lesser(int dimension, Eigen::Index vertices) const {
    std::vector<std::string> warnings;
    std::vector<bool> used;
    for (int k = dimension - 1; k > 0; --k) {
        const PolygonMesh& cells = lists_[k].cells;
        if (cells.size() > 0 && used.empty())
            used = marks_at(lists_[dimension].cells.corners, vertices);
        std::size_t count = 0, most_corners = 0;
        std::span<const Index> first;
        for (Index cell = 0; cell < cells.size(); ++cell) {
            const auto corners = cells.face(cell);
            if (std::all_of(corners.begin(), corners.end(), [&](Index v) { return used[v]; }))
                continue;
            first = count++ == 0 ? corners : first;
            most_corners = std::max(most_corners, corners.size());
        }
        if (count == 0)
            continue;
        const char* const name = k == 1 ? "edge" : most_corners == 3 ? "triangle" : "polygon";
        warnings.push_back(fmt::format("left out {} {}{} with vertices that no cell of dimension "
                                       "{} uses; the first has vertices {}",
                                       count, name, count == 1 ? "" : "s", dimension,
                                       fmt::join(first, ", ")));
    }
    return warnings;
}

Mesh CellLists::mesh(Points points, const SourceFile& file) && {
    int dimension = most_dimensions - 1;
    while (dimension > 1 && lists_[dimension].cells.tags.empty())
        --dimension;
    for (const auto& list : lists_)
        checked_count(list.cells.corners.size(), "corners of cells", file);
    auto warnings = warnings_of_lesser(dimension, points.rows());
    warnings.insert(warnings.end(), warnings_.begin(), warnings_.end());
    if (curved_ > 0)
        warnings.push_back(higher_order_warning(curved_));
    auto& [cells, second_groups] = lists_[dimension];
    auto& [facets, groups] = lists_[dimension - 1];
    for (const auto& [facet, tag] : groups) {
        const auto corners = facets.face(facet);
        facets.add(std::vector(corners.begin(), corners.end()));
        facets.tags.push_back(tag);
    }
    if (!second_groups.empty())
        warnings.push_back(second_groups_warning(second_groups.size()));
    auto facet_tags = pull_tagged(facets, dimension - 1);

    if (std::count(cells.tags.begin(), cells.tags.end(), 0) == std::ssize(cells.tags))
        cells.tags.clear();
    Mesh mesh;
    if (cells.all_have(dimension + 1)) {
        mesh.points = std::move(points);
        mesh.simplices = simplices_of(cells.corners, dimension + 1);
        mesh.tags = std::move(cells.tags);
    } else {
        cells.points = std::move(points);
        mesh = split_cells(std::move(cells), dimension);
    }
    mesh.facet_tags = std::move(facet_tags);
    mesh.warnings.insert(mesh.warnings.begin(), warnings.begin(), warnings.end());
    return mesh;
}

std::string second_groups_warning(std::size_t count) {
    return fmt::format("left out {} second group{} of cells: the first group of a cell is its tag",
                       count, count == 1 ? "" : "s");
}

std::string higher_order_warning(std::size_t cells) {
    return fmt::format(
        "read only the corners of {} of second or higher order; left out midpoints and other nodes",
        cells == 1 ? "1 cell" : fmt::format("{} cells", cells));
}

} // namespace polydec
