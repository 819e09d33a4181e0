// SPDX-License-Identifier: MIT
#include "io/pictures/vtu_solids.h"

#include <algorithm>
#include <cstddef>
#include <span>

namespace polydec {

namespace {

using Faces = std::vector<std::vector<Index>>;

/// The corner behind another one, the way a face runs; -1 if it has no such corner.
Index next_corner(const std::vector<Index>& face, Index corner) {
    const auto place = std::find(face.begin(), face.end(), corner);
    if (place == face.end())
        return -1;
    return place + 1 == face.end() ? face.front() : *(place + 1);
}

/// The other end of the edge at a corner of the base that leads away from it; -1 if there is none.
Index above(const Faces& faces, const std::vector<Index>& base, Index corner) {
    for (auto face = faces.begin() + 1; face != faces.end(); ++face)
        if (const Index next = next_corner(*face, corner); next >= 0 && next_corner(base, next) < 0)
            return next;
    return -1;
}

/// Faces as sets of corners, in order.
Faces as_sets(Faces faces) {
    for (auto& face : faces)
        std::sort(face.begin(), face.end());
    std::sort(faces.begin(), faces.end());
    return faces;
}

/// Whether corners in VTK's order have those faces, which are as many.
template <std::size_t Size, std::size_t Count>
bool has_faces(const std::vector<Index>& corners,
               const std::array<std::array<int, Size>, Count>& table, const Faces& faces) {
    Faces own;
    for (const auto& face : table) {
        own.emplace_back();
        for (const int corner : face)
            own.back().push_back(corners[corner]);
    }
    return as_sets(std::move(own)) == as_sets(faces);
}

} // namespace

bool add_simple_solid(VtuGrid& grid, const Faces& faces) {
    const bool is_tetra = faces.size() == tetra_faces.size() && faces[0].size() == 3;
    const bool is_hexahedron = faces.size() == hexahedron_faces.size() && faces[0].size() == 4;
    if (!is_tetra && !is_hexahedron)
        return false;
    // VTK has the base turned inward, then what lies above its corners
    const std::vector<Index> base(faces[0].rbegin(), faces[0].rend());
    std::vector<Index> corners = base;
    for (const Index corner : std::span(base).first(is_tetra ? 1 : 4))
        corners.push_back(above(faces, base, corner));
    if (std::find(corners.begin(), corners.end(), -1) != corners.end() ||
        !(is_tetra ? has_faces(corners, tetra_faces, faces)
                   : has_faces(corners, hexahedron_faces, faces)))
        return false;
    add_cell(grid, is_tetra ? VtuCell::tetra : VtuCell::hexahedron, corners);
    return true;
}

std::optional<std::vector<std::span<const Index>>>
polyhedron_faces(std::span<const Index> list, std::int64_t begin, std::int64_t end) {
    if (begin < 0 || begin >= end || end > std::ssize(list))
        return std::nullopt;
    std::vector<std::span<const Index>> faces;
    for (std::int64_t at = begin + 1; at < end;) {
        const Index corners = list[at++];
        if (corners < 3 || corners > end - at)
            return std::nullopt;
        faces.push_back(list.subspan(at, corners));
        at += corners;
    }
    if (std::ssize(faces) != list[begin])
        return std::nullopt;
    return faces;
}

} // namespace polydec
