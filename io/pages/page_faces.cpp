// SPDX-License-Identifier: MIT
#include "io/pages/page_faces.h"

#include "io/pictures/vtu_solids.h"
#include "meshes/polygons.h"

#include <algorithm>
#include <span>
#include <tuple>
#include <utility>

namespace polydec {

namespace {

using Ends = std::pair<Index, Index>;

Ends ends_of_side(Index a, Index b) {
    return {std::min(a, b), std::max(a, b)};
}

/// A polygon around a cell.
struct Ring {
    std::vector<Index> sorted, corners;
    Index cell;

    Ring(std::vector<Index> list, Index owner)
        : sorted(list), corners(std::move(list)), cell(owner) {
        std::sort(sorted.begin(), sorted.end());
    }
};

/// VTK's numbers of types ascend with the dimension.
int cell_dimension(VtuCell type) {
    return type <= VtuCell::vertex ? 0 : type <= VtuCell::line ? 1 : type <= VtuCell::quad ? 2 : 3;
}

std::span<const Index> corners_of(const VtuGrid& grid, Index cell) {
    const std::int64_t begin = cell > 0 ? grid.offsets[cell - 1] : 0;
    return std::span(grid.corners).subspan(begin, grid.offsets[cell] - begin);
}

/// The faces of all 3-cells of a grid, as often as they are met.
std::vector<Ring> rings_of_solids(const VtuGrid& grid) {
    std::vector<Ring> rings;
    std::int64_t faces_begin = 0;
    for (Index cell = 0; cell < std::ssize(grid.types); ++cell) {
        const auto corners = corners_of(grid, cell);
        if (grid.types[cell] == VtuCell::tetra)
            for (const auto& [a, b, c] : tetra_faces)
                rings.push_back({{corners[a], corners[b], corners[c]}, cell});
        if (grid.types[cell] == VtuCell::hexahedron)
            for (const auto& [a, b, c, d] : hexahedron_faces)
                rings.push_back({{corners[a], corners[b], corners[c], corners[d]}, cell});
        const std::int64_t faces_end = grid.face_offsets[cell];
        if (grid.types[cell] == VtuCell::polyhedron) {
            const auto faces = polyhedron_faces(grid.faces, faces_begin, faces_end);
            for (const auto& face : faces.value())
                rings.push_back({{face.begin(), face.end()}, cell});
        }
        faces_begin = std::max(faces_begin, faces_end);
    }
    return rings;
}

/// Polygons without points, which have their own numbers as tags, with the cells at each.
struct Surface {
    PolygonMesh polygons;
    std::vector<std::array<Index, 2>> owners;

    void add(std::span<const Index> corners, Index owner, Index other) {
        polygons.add(corners);
        polygons.tags.push_back(static_cast<Index>(owners.size()));
        owners.push_back({owner, other});
    }
};

/// The polygons of a grid, or the faces of its solids; those that two of them share are one.
Surface surface_of(const VtuGrid& grid) {
    Surface surface;
    if (grid_dimension(grid) == 2)
        for (Index cell = 0; cell < std::ssize(grid.types); ++cell)
            if (cell_dimension(grid.types[cell]) == 2)
                surface.add(corners_of(grid, cell), cell, -1);
    auto all = rings_of_solids(grid);
    std::stable_sort(all.begin(), all.end(),
                     [](const Ring& a, const Ring& b) { return a.sorted < b.sorted; });
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool shared = i + 1 < all.size() && all[i].sorted == all[i + 1].sorted;
        surface.add(all[i].corners, all[i].cell, shared ? all[i + 1].cell : -1);
        i += shared ? 1 : 0;
    }
    return surface;
}

/// Which sides of the triangles are true edges: those of the ring that they are split from.
void mark_sides(PageFaces& faces, const PolygonMesh& rings, const std::vector<Index>& ring_of) {
    std::vector<Ends> sides;
    Index known = -1;
    for (Index t = 0; t < faces.size(); ++t) {
        const Index ring = ring_of[t];
        if (ring != known) {
            sides.clear();
            const auto corners = rings.face(ring);
            for (std::size_t i = 0; i < corners.size(); ++i)
                sides.push_back(ends_of_side(corners[i], corners[(i + 1) % corners.size()]));
            std::sort(sides.begin(), sides.end());
            known = ring;
        }
        Index bits = 0;
        for (int i = 0; i < 3; ++i)
            if (std::binary_search(
                    sides.begin(), sides.end(),
                    ends_of_side(faces.corners[3 * t + i], faces.corners[3 * t + (i + 1) % 3])))
                bits |= PageFaces::edge << 2 * i;
        faces.sides.push_back(bits);
    }
}

/// True edges between polygons of one group were merged away.
void mark_removed(PageFaces& faces, const std::vector<Index>& groups) {
    std::vector<std::tuple<Ends, Index, Index>> sides; // ends, group, number of the side
    for (Index i = 0; i < 3 * faces.size(); ++i)
        if ((faces.sides[i / 3] >> 2 * (i % 3) & 3) == PageFaces::edge)
            sides.emplace_back(
                ends_of_side(faces.corners[i], faces.corners[i % 3 < 2 ? i + 1 : i - 2]),
                groups[faces.owners[i / 3][0]], i);
    std::sort(sides.begin(), sides.end());
    const auto is_same = [](const auto& a, const auto& b) {
        return std::get<0>(a) == std::get<0>(b) && std::get<1>(a) == std::get<1>(b);
    };
    for (std::size_t i = 0; i + 1 < sides.size(); ++i)
        if (is_same(sides[i], sides[i + 1]))
            for (const auto& side : {sides[i], sides[i + 1]}) {
                const Index number = std::get<2>(side);
                Index& bits = faces.sides[number / 3];
                bits &= ~(3 << 2 * (number % 3));
                bits |= PageFaces::removed << 2 * (number % 3);
            }
}

void add_lines(PageFaces& faces, const VtuGrid& grid) {
    for (Index cell = 0; cell < std::ssize(grid.types); ++cell)
        if (grid.types[cell] == VtuCell::line) {
            const auto ends = corners_of(grid, cell);
            faces.lines.insert(faces.lines.end(), ends.begin(), ends.end());
            faces.owners.push_back({cell, -1});
        }
}

/// The 3-cells on both sides of each 2-cell.
std::vector<std::array<Index, 2>> cells_at_faces(const CellComplex& complex) {
    std::vector<std::array<Index, 2>> owners(complex.size(2), {-1, -1});
    for (Index cell = 0; cell < complex.size(3); ++cell)
        for (const SignedFace& f : complex.incidences(2)[cell]) {
            auto& both = owners[f.face];
            both[both[0] < 0 ? 0 : 1] = cell;
        }
    return owners;
}

/// The pieces of a curve.
void add_pieces_of_curve(PageFaces& faces, const Merging& merging) {
    const auto& K = merging.pieces();
    for (Index s = 0; s < K.size(1); ++s) {
        for (const int end : {0, 1})
            faces.lines.push_back(K.vertex_number(K.simplices(1)(s, end)));
        faces.owners.push_back({merging.carriers(1)[s].cell, -1});
    }
}

} // namespace

Index PageFaces::count_cells() const {
    Index count = 0;
    for (const auto& [cell, other] : owners)
        count = std::max({count, cell + 1, other + 1});
    return count;
}

PageFaces PageFaces::visible(const std::vector<bool>& kept) const {
    const auto is_kept = [&](Index cell) { return cell >= 0 && kept[cell]; };
    PageFaces result;
    result.dimension = dimension;
    const int size_of_each = dimension < 2 ? 2 : 3;
    for (Index t = 0; t < size(); ++t) {
        const auto [cell, other] = owners[t];
        if (is_kept(cell) == is_kept(other))
            continue;
        result.owners.push_back({is_kept(cell) ? cell : other, -1});
        const auto copy = [&](const std::vector<Index>& from, std::vector<Index>& to, int count) {
            if (!from.empty())
                to.insert(to.end(), from.begin() + count * t, from.begin() + count * (t + 1));
        };
        copy(lines, result.lines, size_of_each);
        copy(corners, result.corners, size_of_each);
        copy(sides, result.sides, 1);
        copy(edges, result.edges, 3);
        copy(faces, result.faces, 1);
    }
    return result;
}

Index PageFaces::entry(std::string_view place, Index corner) const {
    const bool is_curve = dimension < 2;
    const Index t = corner / (is_curve ? 2 : 3);
    return place == "vertex" ? (is_curve ? lines : corners)[corner]
           : place == "cell" ? owners[t][0]
           : place == "face" ? faces[t]
                             : edges[corner];
}

int grid_dimension(const VtuGrid& grid) {
    return grid.types.empty()
               ? 0
               : cell_dimension(*std::max_element(grid.types.begin(), grid.types.end()));
}

PageFaces page_faces(const VtuGrid& grid, const std::vector<Index>& groups) {
    PageFaces faces;
    faces.dimension = grid_dimension(grid);
    if (faces.dimension < 2) {
        add_lines(faces, grid);
        return faces;
    }
    auto [polygons, owners] = surface_of(grid);
    polygons.points = grid.points;
    const Mesh split = split_polygons(polygons);
    faces.corners.assign(split.simplices.data(), split.simplices.data() + split.simplices.size());
    for (const Index ring : split.tags)
        faces.owners.push_back(owners[ring]);
    mark_sides(faces, polygons, split.tags);
    if (!groups.empty())
        mark_removed(faces, groups);
    return faces;
}

PageFaces page_faces(const Merging& merging) {
    const auto& K = merging.pieces();
    const auto& P = merging.merged();
    PageFaces faces;
    faces.dimension = P.dimension();
    if (faces.dimension < 2) {
        add_pieces_of_curve(faces, merging);
        return faces;
    }
    const auto owners = cells_at_faces(P);
    const auto &edges = merging.carriers(1), &triangles = merging.carriers(2);
    for (Index s = 0; s < K.size(2); ++s) {
        const auto [dimension, face] = triangles[s];
        if (dimension > 2)
            continue; // within a merged solid
        faces.owners.push_back(faces.dimension > 2 ? owners[face] : std::array<Index, 2>{face, -1});
        faces.faces.push_back(face);
        Index bits = 0;
        for (int i = 0; i < 3; ++i) {
            const auto& carrier = edges[K.face(2, s, (i + 2) % 3)];
            const bool is_edge = carrier.dimension == 1;
            bits |= (is_edge ? PageFaces::edge : PageFaces::removed) << 2 * i;
            faces.edges.push_back(is_edge ? carrier.cell : -1);
            faces.corners.push_back(K.vertex_number(K.simplices(2)(s, i)));
        }
        faces.sides.push_back(bits);
    }
    return faces;
}

} // namespace polydec
