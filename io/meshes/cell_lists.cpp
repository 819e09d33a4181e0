// SPDX-License-Identifier: MIT
#include "io/meshes/cell_lists.h"

#include "io/meshes/readers.h"
#include "meshes/split_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace polydec {

namespace {

bool are_uniform(const std::vector<Index>& offsets, int corners) {
    const auto differs = [corners](Index begin, Index end) { return end - begin != corners; };
    return std::adjacent_find(offsets.begin(), offsets.end(), differs) == offsets.end();
}

} // namespace

void CellLists::add(int dimension, std::span<const Index> corners, Index tag,
                    const SourceFile& file) {
    auto& list = lists_[dimension];
    list.corners.insert(list.corners.end(), corners.begin(), corners.end());
    list.offsets.push_back(checked_count(list.corners.size(), "corners of cells", file));
    list.tags.push_back(tag);
}

void CellLists::add_tag(int dimension, Index tag) {
    auto& list = lists_[dimension];
    list.more.emplace_back(static_cast<Index>(list.tags.size()) - 1, tag);
}

/// Cells of smaller dimension mostly bound those of the mesh. Others would be missed.
std::vector<std::string> CellLists::warnings_of_lesser(int dimension, Eigen::Index vertices) {
    std::vector<std::string> warnings;
    std::vector<char> used(vertices, 0);
    for (const Index corner : list(dimension).corners)
        used[corner] = 1;
    for (int k = dimension - 1; k > 0; --k) {
        const auto& [corners, offsets, tags, more] = list(k);
        std::size_t count = 0, first = 0, most_corners = 0;
        for (std::size_t cell = 0; cell < tags.size(); ++cell) {
            const auto begin = corners.begin() + offsets[cell];
            const auto end = corners.begin() + offsets[cell + 1];
            if (std::all_of(begin, end, [&](Index v) { return used[v]; }))
                continue;
            first = count++ == 0 ? cell : first;
            most_corners = std::max(most_corners, static_cast<std::size_t>(end - begin));
        }
        if (count == 0)
            continue;
        const char* const name = k == 1 ? "edge" : most_corners == 3 ? "triangle" : "polygon";
        warnings.push_back(fmt::format("left out {} {}{} with vertices that no cell of dimension "
                                       "{} uses; the first has vertices {}",
                                       count, name, count == 1 ? "" : "s", dimension,
                                       fmt::join(corners.begin() + offsets[first],
                                                 corners.begin() + offsets[first + 1], ", ")));
    }
    return warnings;
}

Mesh CellLists::mesh(Points points) && {
    int dimension = most_dimensions - 1;
    while (dimension > 1 && list(dimension).tags.empty())
        --dimension;
    auto warnings = warnings_of_lesser(dimension, points.rows());
    if (curved_ > 0)
        warnings.push_back(higher_order_warning(curved_));
    auto& lesser = list(dimension - 1);
    for (const auto& [cell, tag] : std::exchange(lesser.more, {})) {
        const auto begin = lesser.offsets[cell], end = lesser.offsets[cell + 1];
        for (Index i = begin; i < end; ++i)
            lesser.corners.push_back(lesser.corners[i]);
        lesser.offsets.push_back(lesser.offsets.back() + end - begin);
        lesser.tags.push_back(tag);
    }
    if (const auto more = list(dimension).more.size(); more > 0)
        warnings.push_back(second_groups_warning(more));
    auto facet_tags = pull_tagged(dimension - 1, lesser.corners, lesser.offsets, lesser.tags);

    auto& cells = list(dimension);
    auto tags = tags_or_none(std::move(cells.tags));
    Mesh mesh;
    if (are_uniform(cells.offsets, dimension + 1)) {
        mesh.points = std::move(points);
        const auto rows = static_cast<Eigen::Index>(cells.offsets.size()) - 1;
        mesh.simplices = Eigen::Map<const Simplices>(cells.corners.data(), rows, dimension + 1);
        mesh.tags = std::move(tags);
    } else {
        mesh = split_cells({std::move(points), std::move(cells.corners), std::move(cells.offsets),
                            std::move(tags)},
                           dimension);
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

std::vector<Index> tags_from(const std::vector<double>& numbers) {
    const bool fit = std::all_of(numbers.begin(), numbers.end(), [](double number) {
        return number == std::floor(number) && std::abs(number) < 0x1p31;
    });
    return fit ? std::vector<Index>(numbers.begin(), numbers.end())
               : std::vector<Index>(numbers.size(), 0);
}

std::vector<Index> tags_or_none(std::vector<Index> tags) {
    if (std::all_of(tags.begin(), tags.end(), [](Index tag) { return tag == 0; }))
        tags.clear();
    return tags;
}

} // namespace polydec
