// SPDX-License-Identifier: MIT
#include "io/meshes/cell_lists.h"

#include "io/meshes/readers.h"
#include "meshes/polygons.h"

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
    auto& list = lists_[static_cast<std::size_t>(dimension)];
    list.corners.insert(list.corners.end(), corners.begin(), corners.end());
    list.offsets.push_back(checked_count(list.corners.size(), "corners of cells", file));
    list.tags.push_back(tag);
}

/// What has another number of corners is no facet of a simplex.
TaggedSimplices CellLists::tagged(const List& list, int corners) {
    TaggedSimplices result;
    std::vector<Index> vertices;
    for (std::size_t cell = 0; cell < list.tags.size(); ++cell) {
        const auto begin = list.corners.begin() + list.offsets[cell];
        const auto end = list.corners.begin() + list.offsets[cell + 1];
        if (list.tags[cell] == 0 || end - begin != corners)
            continue;
        vertices.insert(vertices.end(), begin, end);
        result.tags.push_back(list.tags[cell]);
    }
    const auto rows = static_cast<Eigen::Index>(result.tags.size());
    result.simplices = Eigen::Map<const Simplices>(vertices.data(), rows, corners);
    return result;
}

Mesh CellLists::mesh(Points points) && {
    int dimension = most_dimensions - 1;
    while (dimension > 1 && lists_[static_cast<std::size_t>(dimension)].tags.empty())
        --dimension;
    auto& list = lists_[static_cast<std::size_t>(dimension)];
    auto tags = tags_or_none(std::move(list.tags));

    auto facet_tags = tagged(lists_[static_cast<std::size_t>(dimension - 1)], dimension);

    // Polygons alone can have another number of corners than a simplex.
    if (!are_uniform(list.offsets, dimension + 1)) {
        Mesh mesh = split_polygons(
            {std::move(points), std::move(list.corners), std::move(list.offsets), std::move(tags)});
        mesh.facet_tags = std::move(facet_tags);
        return mesh;
    }
    Mesh mesh;
    mesh.points = std::move(points);
    const auto cells = static_cast<Eigen::Index>(list.offsets.size()) - 1;
    mesh.simplices = Eigen::Map<const Simplices>(list.corners.data(), cells, dimension + 1);
    mesh.tags = std::move(tags);
    mesh.facet_tags = std::move(facet_tags);
    return mesh;
}

std::optional<Index> tag_from(double number) {
    const bool fits = number == std::floor(number) && std::abs(number) < 0x1p31;
    return fits ? std::optional(static_cast<Index>(number)) : std::nullopt;
}

std::vector<Index> tags_or_none(std::vector<Index> tags) {
    if (std::all_of(tags.begin(), tags.end(), [](Index tag) { return tag == 0; }))
        tags.clear();
    return tags;
}

} // namespace polydec
