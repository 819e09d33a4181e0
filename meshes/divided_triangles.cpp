// SPDX-License-Identifier: MIT
#include "meshes/divided_triangles.h"

#include "base/lists.h"
#include "meshes/polygons.h"

#include <algorithm>

namespace polydec {

DividedEdges::DividedEdges(std::vector<Entry> entries) : entries_(std::move(entries)) {
    sort_unique(entries_);
}

bool DividedEdges::contains(Index a, Index b) const {
    const auto [begin, end] = of(std::min(a, b), std::max(a, b));
    return begin != end;
}

void DividedEdges::append(Index a, Index b, std::vector<Index>& corners) const {
    corners.push_back(a);
    const auto [begin, end] = of(std::min(a, b), std::max(a, b));
    const auto first = std::ssize(corners);
    for (auto entry = begin; entry != end; ++entry)
        corners.push_back(entry->vertex);
    if (a > b)
        std::reverse(corners.begin() + first, corners.end());
}

auto DividedEdges::of(Index a, Index b) const -> std::pair<Place, Place> {
    const auto before = [](const Entry& entry, const std::pair<Index, Index>& edge) {
        return std::pair(entry.a, entry.b) < edge;
    };
    return {std::lower_bound(entries_.begin(), entries_.end(), std::pair(a, b), before),
            std::lower_bound(entries_.begin(), entries_.end(), std::pair(a, b + 1), before)};
}

Triangle ascending(Triangle corners) {
    std::sort(corners.begin(), corners.end());
    return corners;
}

DividedTriangles::DividedTriangles(DividedEdges edges, std::vector<TrianglePart> tiles)
    : edges_(std::move(edges)), parts_(std::move(tiles)) {
    std::sort(parts_.begin(), parts_.end());
}

auto DividedTriangles::of(const Triangle& corners) const -> std::pair<Place, Place> {
    const auto first = std::lower_bound(parts_.begin(), parts_.end(), TrianglePart(corners, {}));
    return {first, std::find_if(first, parts_.end(),
                                [&](const auto& part) { return part.first != corners; })};
}

bool DividedTriangles::is_divided(const Triangle& corners) const {
    const auto [a, b, c] = corners;
    const auto [begin, end] = of(ascending(corners));
    return begin != end || edges_.contains(a, b) || edges_.contains(b, c) || edges_.contains(c, a);
}

void DividedTriangles::divide(std::vector<Triangle> triangles, const Points& points) {
    sort_unique(triangles);
    PolygonMesh polygons{points, {}};
    std::vector<Triangle> divided;
    for (const Triangle& triangle : triangles) {
        const auto [begin, end] = of(triangle);
        if (begin != end || !is_divided(triangle))
            continue;
        for (std::size_t i = 0; i < 3; ++i)
            edges_.append(triangle[i], triangle[(i + 1) % 3], polygons.corners);
        polygons.offsets.push_back(static_cast<Index>(polygons.corners.size()));
        polygons.tags.push_back(static_cast<Index>(divided.size()));
        divided.push_back(triangle);
    }
    const Mesh split = split_polygons(std::move(polygons));
    for (Index t = 0; t < split.simplices.rows(); ++t) {
        const auto part = split.simplices.row(t);
        parts_.push_back({divided[split.tags[t]], {part[0], part[1], part[2]}});
    }
    std::sort(parts_.begin(), parts_.end());
}

std::vector<Triangle> DividedTriangles::parts(const Triangle& corners) const {
    const auto [begin, end] = of(corners);
    std::vector<Triangle> result;
    for (auto part = begin; part != end; ++part)
        result.push_back(part->second);
    return result.empty() ? std::vector{corners} : result;
}

} // namespace polydec
