// SPDX-License-Identifier: MIT
#include "io/meshes/vtk_cells.h"

#include "base/checks.h"
#include "io/meshes/cell_lists.h"
#include "io/meshes/readers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace polydec {

namespace {

/// How the numbers of a cell become cells of the mesh: strips and polylines are many; pixels and
/// voxels have their corners along the axes, not around.
enum class Order { around, along_axes, edges, strip, half_are_corners };

struct CellKind {
    int type;
    int dimension;
    std::size_t corners; ///< the first of its nodes, or any_number
    std::size_t nodes;   ///< any_number for cells of any order
    Order order = Order::around;
};

constexpr std::size_t any_number = 1U << 31U;
constexpr std::array cell_kinds{
    CellKind{0, 0, any_number, any_number}, // an empty cell
    CellKind{1, 0, 1, 1},
    CellKind{2, 0, any_number, any_number},
    CellKind{3, 1, 2, 2},
    CellKind{4, 1, any_number, any_number, Order::edges},
    CellKind{5, 2, 3, 3},
    CellKind{6, 2, any_number, any_number, Order::strip},
    CellKind{7, 2, any_number, any_number},
    CellKind{8, 2, 4, 4, Order::along_axes},
    CellKind{9, 2, 4, 4},
    CellKind{10, 3, 4, 4},
    CellKind{11, 3, 8, 8, Order::along_axes},
    CellKind{12, 3, 8, 8},
    CellKind{13, 3, 6, 6},
    CellKind{14, 3, 5, 5},
    CellKind{15, 3, 10, 10},
    CellKind{16, 3, 12, 12},
    // second order: on edges, and of some in faces and inside
    CellKind{21, 1, 2, 3},
    CellKind{22, 2, 3, 6},
    CellKind{23, 2, 4, 8},
    CellKind{24, 3, 4, 10},
    CellKind{25, 3, 8, 20},
    CellKind{26, 3, 6, 15},
    CellKind{27, 3, 5, 13},
    CellKind{28, 2, 4, 9},
    CellKind{29, 3, 8, 27},
    CellKind{30, 2, 4, 6},
    CellKind{31, 3, 6, 12},
    CellKind{32, 3, 6, 18},
    CellKind{33, 3, 8, 24},
    CellKind{34, 2, 3, 7},
    CellKind{35, 1, 2, 4},
    CellKind{36, 2, any_number, any_number, Order::half_are_corners},
    CellKind{37, 3, 5, 19},
    // Lagrange's cells of any order
    CellKind{68, 1, 2, any_number},
    CellKind{69, 2, 3, any_number},
    CellKind{70, 2, 4, any_number},
    CellKind{71, 3, 4, any_number},
    CellKind{72, 3, 8, any_number},
    CellKind{73, 3, 6, any_number},
    CellKind{74, 3, 5, any_number},
};
constexpr int first_lagrange = 68, from_lagrange_to_bezier = 7; // which have the same corners

class Converter {
public:
    Converter(const VtkArrays& arrays, const Scanner& place, const SourceFile& file)
        : arrays_(arrays), place_(place), file_(file) {}

    Mesh mesh() {
        Points points = converted_points();
        check_sizes();
        tags_ = arrays_.tags.empty() ? std::vector<Index>(arrays_.types.size())
                                     : cells_.tags_from(arrays_.tags, arrays_.types.size());
        std::size_t begin = 0;
        for (std::size_t cell = 0; cell < arrays_.types.size(); ++cell)
            begin = convert(cell, begin);
        return std::move(cells_).mesh(std::move(points), file_);
    }

private:
    Points converted_points() {
        const auto values = arrays_.points.size();
        if (values % 3 != 0)
            place_.fail(fmt::format("the points have {} coordinates; expected three for each; "
                                    "export it again",
                                    values));
        vertices_ = checked_count(values / 3, "vertices", file_);
        return points_from(arrays_.points);
    }

    void check_sizes() const {
        const auto last = arrays_.ends.empty() ? 0.0 : arrays_.ends.back();
        if (arrays_.ends.size() != arrays_.types.size() ||
            last != static_cast<double>(arrays_.corners.size()))
            place_.fail(fmt::format(
                "{} types, {} offsets up to {} and {} corners of cells do not match; expected an "
                "offset for each type, up to the number of corners; export it again",
                arrays_.types.size(), arrays_.ends.size(), last, arrays_.corners.size()));
    }

    std::size_t convert(std::size_t cell, std::size_t begin) {
        const auto& kind = kind_of(cell);
        const double end = arrays_.ends[cell];
        if (!(end >= static_cast<double>(begin) &&
              end <= static_cast<double>(arrays_.corners.size())) ||
            end != std::floor(end))
            place_.fail(fmt::format("the corners of cell {} end at {}; expected a whole number "
                                    "from {} to {}; export it again",
                                    cell, end, begin, arrays_.corners.size()));
        const auto nodes = static_cast<std::size_t>(end) - begin;
        if (!fits(kind, nodes))
            place_.fail(fmt::format("cell {} of VTK's type {} has {} corners; expected the "
                                    "corners of its type; export it again",
                                    cell, arrays_.types[cell], nodes));
        corners_.clear();
        for (std::size_t i = begin; i < begin + nodes; ++i)
            corners_.push_back(vertex_at(i, cell));
        if (kind.order == Order::half_are_corners)
            corners_.resize(nodes / 2);
        else if (kind.corners != any_number)
            corners_.resize(kind.corners);
        add(kind, tags_[cell]);
        cells_.leave_out_nodes(nodes - corners_.size());
        return begin + nodes;
    }

    static bool fits(const CellKind& kind, std::size_t nodes) {
        if (kind.order == Order::edges || kind.order == Order::strip)
            return nodes >= static_cast<std::size_t>(kind.dimension) + 1;
        const bool is_any = kind.nodes == any_number;
        return is_any ? kind.corners == any_number || nodes >= kind.corners : nodes == kind.nodes;
    }

    const CellKind& kind_of(std::size_t cell) const {
        const double type = arrays_.types[cell];
        for (const auto& kind : cell_kinds)
            if (kind.type == type ||
                (kind.type >= first_lagrange && kind.type + from_lagrange_to_bezier == type))
                return kind;
        constexpr double polyhedron = 42;
        place_.fail(fmt::format(
            "cell {} is {}of VTK's type {}, which is not supported; expected tetrahedra, "
            "hexahedra, wedges, pyramids (10 to 16), polygons (5 to 9) or lines (3, 4); {}",
            cell, type == polyhedron ? "a polyhedron, " : "", type,
            type == polyhedron ? "read the mesh that it comes from" : "convert it first"));
    }

    Index vertex_at(std::size_t place, std::size_t cell) const {
        const double value = arrays_.corners[place];
        if (!(value >= 0.0 && value < vertices_) || value != std::floor(value))
            place_.fail(fmt::format("cell {} has the vertex number {}; {}; correct the index or "
                                    "add the vertex",
                                    cell, value, expected_numbers(0, vertices_ - 1)));
        return static_cast<Index>(value);
    }

    void add(const CellKind& kind, Index tag) {
        const std::span<const Index> corners = corners_;
        switch (kind.order) {
        case Order::along_axes:
            for (std::size_t i = 2; i < corners_.size(); i += 4)
                std::swap(corners_[i], corners_[i + 1]);
            [[fallthrough]];
        case Order::around:
        case Order::half_are_corners:
            return cells_.add(kind.dimension, corners, tag);
        case Order::edges:
            for (std::size_t i = 0; i + 1 < corners.size(); ++i)
                cells_.add(kind.dimension, corners.subspan(i, 2), tag);
            return;
        case Order::strip:
            for (std::size_t i = 0; i + 2 < corners.size(); ++i)
                add_strip_triangle(corners.subspan(i, 3), i % 2 != 0, tag);
        }
    }

    /// Every other triangle of a strip has its corners the other way around.
    void add_strip_triangle(std::span<const Index> corners, bool turned, Index tag) {
        const std::array triangle{corners[0], corners[turned ? 2 : 1], corners[turned ? 1 : 2]};
        cells_.add(2, triangle, tag);
    }

    const VtkArrays& arrays_;
    const Scanner& place_;
    const SourceFile& file_;
    Index vertices_ = 0;
    std::vector<Index> tags_;
    std::vector<Index> corners_;
    CellLists cells_;
};

} // namespace

Mesh vtk_mesh(const VtkArrays& arrays, const Scanner& place, const SourceFile& file) {
    return Converter(arrays, place, file).mesh();
}

void check_points(const std::vector<double>& points, std::size_t begin, const Scanner& place) {
    for (std::size_t i = begin; i < points.size(); ++i)
        place.as_coordinate(points[i], static_cast<Index>(i / 3));
}

bool is_tag_name(std::string_view name) {
    constexpr std::array<std::string_view, 6> names{"gmsh:physical", "medit:ref", "tetgen:ref",
                                                    "CellEntityIds", "material",  "attribute"};
    return std::find(names.begin(), names.end(), name) != names.end();
}

} // namespace polydec
