// SPDX-License-Identifier: MIT
#include "io/meshes/vtk_cells.h"

#include "io/meshes/cell_lists.h"
#include "io/meshes/readers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>

namespace polydec {

namespace {

using Corners = std::span<const Index>;

/// How the corners of a cell become simplices or polygons.
enum class Shape { as_it_is, pixel, edges, strip };

struct CellKind {
    int type;
    int dimension;
    std::size_t least_corners, most_corners;
    Shape shape;
};

constexpr std::size_t any_number = 1U << 31U;
constexpr std::array cell_kinds{
    CellKind{0, 0, 0, any_number, Shape::as_it_is}, // an empty cell
    CellKind{1, 0, 1, 1, Shape::as_it_is},          CellKind{2, 0, 0, any_number, Shape::as_it_is},
    CellKind{3, 1, 2, 2, Shape::as_it_is},          CellKind{4, 1, 2, any_number, Shape::edges},
    CellKind{5, 2, 3, 3, Shape::as_it_is},          CellKind{6, 2, 3, any_number, Shape::strip},
    CellKind{7, 2, 0, any_number, Shape::as_it_is}, CellKind{8, 2, 4, 4, Shape::pixel},
    CellKind{9, 2, 4, 4, Shape::as_it_is},          CellKind{10, 3, 4, 4, Shape::as_it_is},
};

/// What to do about cells that are not read.
struct Refusal {
    int first_type, last_type;
    const char* name;
    const char* advice;
};

constexpr std::array refusals{
    Refusal{11, 11, "a voxel", "split it into tetrahedra before"},
    Refusal{12, 12, "a hexahedron", "split it into tetrahedra before"},
    Refusal{13, 13, "a wedge", "split it into tetrahedra before"},
    Refusal{14, 14, "a pyramid", "split it into tetrahedra before"},
    Refusal{15, 16, "a prism", "split it into tetrahedra before"},
    Refusal{21, 37, "of second order", "export the mesh with cells of first order"},
    Refusal{42, 42, "a polyhedron", "read the mesh it was made from, or split it into tetrahedra"},
    Refusal{51, 81, "of higher order", "export the mesh with cells of first order"},
};

class Converter {
public:
    Converter(const VtkArrays& arrays, const Scanner& place, const SourceFile& file)
        : arrays_(arrays), place_(place), file_(file) {}

    Mesh mesh() {
        Points points = converted_points();
        check_sizes();
        take_tags();
        std::size_t begin = 0;
        for (std::size_t cell = 0; cell < arrays_.types.size(); ++cell)
            begin = convert(cell, begin);
        return std::move(cells_).mesh(std::move(points));
    }

private:
    Points converted_points() {
        const auto values = arrays_.points.size();
        if (values % 3 != 0) {
            place_.fail(fmt::format("the points have {} coordinates; expected three for each; "
                                    "export it again",
                                    values));
        }
        vertices_ = checked_count(values / 3, "vertices", file_);
        Points points = points_from(arrays_.points);
        for (Index vertex = 0; vertex < vertices_; ++vertex)
            for (const double coordinate : points.row(vertex))
                place_.as_coordinate(coordinate, vertex);
        return points;
    }

    void check_sizes() const {
        const auto last = arrays_.ends.empty() ? 0.0 : arrays_.ends.back();
        if (arrays_.ends.size() != arrays_.types.size() ||
            last != static_cast<double>(arrays_.corners.size())) {
            place_.fail(fmt::format("{} types, {} offsets up to {} and {} corners of cells do not "
                                    "belong together; expected an offset for each type, up to the "
                                    "number of corners; export it again",
                                    arrays_.types.size(), arrays_.ends.size(), last,
                                    arrays_.corners.size()));
        }
    }

    /// Numbers that are not whole name no groups, but something else of the same name.
    void take_tags() {
        tags_.assign(arrays_.types.size(), 0);
        if (arrays_.tags.size() != tags_.size())
            return;
        for (std::size_t cell = 0; cell < tags_.size(); ++cell) {
            const auto tag = tag_from(arrays_.tags[cell]);
            if (!tag) {
                tags_.assign(tags_.size(), 0);
                return;
            }
            tags_[cell] = *tag;
        }
    }

    std::size_t convert(std::size_t cell, std::size_t begin) {
        const auto& kind = kind_of(cell);
        const double end = arrays_.ends[cell];
        if (!(end >= static_cast<double>(begin) &&
              end <= static_cast<double>(arrays_.corners.size())) ||
            end != std::floor(end)) {
            place_.fail(fmt::format("the corners of cell {} end at {}; expected a whole number "
                                    "from {} to {}; export it again",
                                    cell, end, begin, arrays_.corners.size()));
        }
        const auto corners = static_cast<std::size_t>(end) - begin;
        if (corners < kind.least_corners || corners > kind.most_corners) {
            place_.fail(fmt::format("cell {} of VTK's type {} has {} corners; expected the "
                                    "corners of its type; export it again",
                                    cell, kind.type, corners));
        }
        corners_.clear();
        for (std::size_t i = begin; i < begin + corners; ++i)
            corners_.push_back(vertex_at(i, cell));
        add(kind, tags_[cell]);
        return begin + corners;
    }

    const CellKind& kind_of(std::size_t cell) const {
        const double type = arrays_.types[cell];
        for (const auto& kind : cell_kinds)
            if (kind.type == type)
                return kind;
        for (const auto& refusal : refusals) {
            if (type >= refusal.first_type && type <= refusal.last_type) {
                place_.fail(fmt::format("cell {} is {} (VTK's type {}); expected tetrahedra, "
                                        "polygons or lines; {}",
                                        cell, refusal.name, type, refusal.advice));
            }
        }
        place_.fail(fmt::format("cell {} is of VTK's type {}; expected tetrahedra (10), polygons "
                                "(5 to 9) or lines (3, 4); convert it before",
                                cell, type));
    }

    Index vertex_at(std::size_t place, std::size_t cell) const {
        const double value = arrays_.corners[place];
        if (!(value >= 0.0 && value < vertices_) || value != std::floor(value)) {
            place_.fail(fmt::format("cell {} has the vertex number {}; expected 0 to {}; correct "
                                    "the index or add the vertex",
                                    cell, value, vertices_ - 1));
        }
        return static_cast<Index>(value);
    }

    void add(const CellKind& kind, Index tag) {
        const Corners corners = corners_;
        switch (kind.shape) {
        case Shape::as_it_is:
            return cells_.add(kind.dimension, corners, tag, file_);
        case Shape::pixel:
            // Its corners go along the axes, not around.
            std::swap(corners_[2], corners_[3]);
            return cells_.add(kind.dimension, corners, tag, file_);
        case Shape::edges:
            for (std::size_t i = 0; i + 1 < corners.size(); ++i)
                cells_.add(kind.dimension, corners.subspan(i, 2), tag, file_);
            return;
        case Shape::strip:
            for (std::size_t i = 0; i + 2 < corners.size(); ++i)
                add_strip_triangle(corners.subspan(i, 3), i % 2 != 0, tag);
        }
    }

    /// Every other triangle of a strip has its corners the other way around.
    void add_strip_triangle(Corners corners, bool turned, Index tag) {
        const std::array triangle{corners[0], corners[turned ? 2 : 1], corners[turned ? 1 : 2]};
        cells_.add(2, triangle, tag, file_);
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

bool is_tag_name(std::string_view name) {
    constexpr std::array<std::string_view, 6> names{"gmsh:physical", "medit:ref", "tetgen:ref",
                                                    "CellEntityIds", "material",  "attribute"};
    return std::find(names.begin(), names.end(), name) != names.end();
}

} // namespace polydec
