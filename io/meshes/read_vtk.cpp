// SPDX-License-Identifier: MIT
#include "io/meshes/readers.h"
#include "io/meshes/vtk_cells.h"
#include "io/meshes/vtk_grid.h"
#include "io/meshes/vtk_source.h"
#include "io/number_type.h"
#include "io/scanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <utility>

namespace polydec {

namespace {

class VtkReader {
public:
    explicit VtkReader(const SourceFile& file)
        : file_(file), source_({file.name, file.text}), cells_place_(scanner_) {}

    Mesh read() {
        has_offsets_ = source_.read_header() >= 5.0;
        read_kind();
        bool goes_on = true;
        while (goes_on && !scanner_.at_end())
            goes_on = read_section();
        if (kind_ == "polydata")
            join_lists();
        if (has_grid())
            make_grid();
        Mesh mesh = vtk_mesh(arrays_, cells_place_, file_);
        mesh.warnings.insert(mesh.warnings.end(), warnings_.begin(), warnings_.end());
        return mesh;
    }

private:
    /// Cells of one section: those of a PolyData come in four, each of one type.
    struct List {
        const char* keyword;
        double type;
        std::vector<double> corners, ends;
    };

    void read_kind() {
        const auto keyword = source_.keyword("DATASET");
        kind_ = source_.keyword("the kind of the data set");
        constexpr std::array<std::string_view, 5> kinds{"unstructured_grid", "polydata",
                                                        "structured_points", "structured_grid",
                                                        "rectilinear_grid"};
        if (keyword != "dataset" || std::find(kinds.begin(), kinds.end(), kind_) == kinds.end())
            scanner_.fail(fmt::format("a data set of the kind {}; expected DATASET "
                                      "UNSTRUCTURED_GRID, POLYDATA or a structured grid; convert "
                                      "it, for instance with ParaView",
                                      quote_word(kind_)));
    }

    /// Cells are numbered, not listed.
    bool has_grid() const { return kind_ != "polydata" && kind_ != "unstructured_grid"; }

    /// False at the end of what has to be read.
    bool read_section() {
        const Scanner place = scanner_;
        const auto keyword = source_.keyword("a keyword");
        const auto list = std::find_if(lists_.begin(), lists_.end(), [&keyword](const List& one) {
            return keyword == one.keyword;
        });
        if (keyword == "points") {
            const auto count = 3 * source_.size("points");
            arrays_.points = source_.values(source_.read_type(), count);
            check_points(arrays_.points, 0, place);
        } else if (kind_ == "unstructured_grid" && keyword == "cells") {
            cells_place_ = place;
            read_cells(arrays_.corners, arrays_.ends);
        } else if (kind_ == "unstructured_grid" && keyword == "cell_types") {
            arrays_.types = source_.values(NumberType::int32, source_.size("cell types"));
        } else if (kind_ == "polydata" && list != lists_.end()) {
            cells_place_ = place;
            read_cells(list->corners, list->ends);
        } else if (keyword == "cell_data") {
            cell_data_ = source_.size("cells with data");
            in_cell_data_ = true;
        } else if (keyword == "point_data") {
            point_data_ = source_.size("points with data");
            in_cell_data_ = false;
        } else if (keyword == "metadata") {
            source_.skip_metadata();
        } else if (!has_grid() || !read_grid(place, keyword)) {
            return read_attribute(place, keyword);
        }
        return true;
    }

    /// How many points a grid has along the axes, and where; false for other keywords.
    bool read_grid(const Scanner& place, const std::string& keyword) {
        constexpr std::array<std::string_view, 3> coordinates{"x_coordinates", "y_coordinates",
                                                              "z_coordinates"};
        const auto axis = static_cast<std::size_t>(
            std::find(coordinates.begin(), coordinates.end(), keyword) - coordinates.begin());
        if (keyword == "dimensions") {
            cells_place_ = place;
            for (auto& points : grid_.points)
                points = source_.size("points along an axis");
        } else if (keyword == "origin") {
            read_three(origin_);
        } else if (keyword == "spacing" || keyword == "aspect_ratio") {
            read_three(spacing_);
        } else if (axis < coordinates.size()) {
            const auto count = source_.size("coordinates");
            grid_.places[axis] = source_.values(source_.read_type(), count);
        } else {
            return false;
        }
        return true;
    }

    void read_three(std::array<double, 3>& numbers) {
        for (auto& number : numbers)
            number = scanner_.number("a number");
    }

    /// What is missing of places is left to the checks of the mesh.
    void make_grid() {
        if (kind_ != "structured_grid") {
            for (std::size_t axis = 0; axis < 3; ++axis)
                make_places(axis);
            arrays_.points = grid_points(grid_, cells_place_);
            check_points(arrays_.points, 0, cells_place_);
        }
        if (arrays_.points.size() != 3 * grid_.points[0] * grid_.points[1] * grid_.points[2])
            cells_place_.fail(fmt::format(
                "{} points for a grid of {} x {} x {}; expected the product; export it again",
                arrays_.points.size() / 3, grid_.points[0], grid_.points[1], grid_.points[2]));
        add_grid_cells(grid_, cells_place_, arrays_);
    }

    void make_places(std::size_t axis) {
        auto& places = grid_.places[axis];
        if (kind_ == "structured_points") {
            check_grid(grid_, cells_place_);
            for (std::size_t i = 0; i < grid_.points[axis]; ++i)
                places.push_back(origin_[axis] + static_cast<double>(i) * spacing_[axis]);
        } else if (places.size() != grid_.points[axis]) {
            cells_place_.fail(fmt::format("{} coordinates along axis {} for {} points; expected "
                                          "equal numbers; export it again",
                                          places.size(), axis, grid_.points[axis]));
        }
    }

    void read_cells(std::vector<double>& corners, std::vector<double>& ends) {
        const std::size_t first = source_.size("cells");
        const std::size_t second = source_.size("numbers of cells");
        corners.clear();
        ends.clear();
        if (has_offsets_) {
            read_offsets(first, ends);
            read_keyword("connectivity");
            corners = source_.values(source_.read_type(), second);
        } else {
            divide(source_.values(NumberType::int32, second), first, corners, ends);
        }
        const double last = ends.empty() ? 0.0 : ends.back();
        if (last != static_cast<double>(corners.size()))
            cells_place_.fail(fmt::format("the offsets end with {}, but there are {} corners of "
                                          "cells; expected that number; export it again",
                                          last, corners.size()));
    }

    void read_keyword(const char* expected) {
        const auto word = scanner_.word(expected);
        if (lower_case(word) != expected)
            scanner_.fail(fmt::format(
                "found {} among the cells; expected {}, as in version 5; export it again",
                quote_word(word), expected));
    }

    /// Since version 5, offsets are where the corners of a cell begin, and then where all end.
    void read_offsets(std::size_t count, std::vector<double>& ends) {
        read_keyword("offsets");
        ends = source_.values(source_.read_type(), count);
        if (!ends.empty()) {
            if (ends.front() != 0.0)
                scanner_.fail(fmt::format("the offsets begin with {}; expected 0; export it again",
                                          ends.front()));
            ends.erase(ends.begin());
        }
    }

    /// Before, the number of corners stood in front of those of each cell.
    void divide(const std::vector<double>& numbers, std::size_t cells, std::vector<double>& corners,
                std::vector<double>& ends) const {
        std::size_t place = 0;
        for (std::size_t cell = 0; cell < cells; ++cell) {
            const double most =
                static_cast<double>(numbers.size()) - static_cast<double>(place) - 1;
            const double length = place < numbers.size() ? numbers[place] : -1.0;
            if (!(length >= 0.0 && length <= most) ||
                length != static_cast<double>(static_cast<std::size_t>(length)))
                cells_place_.fail(fmt::format("the {} numbers of cells end within cell {} of {}; "
                                              "expected a number of corners and these for each; "
                                              "correct the line",
                                              numbers.size(), cell, cells));
            const auto begin = numbers.begin() + place + 1;
            corners.insert(corners.end(), begin, begin + static_cast<std::ptrdiff_t>(length));
            ends.push_back(static_cast<double>(corners.size()));
            place += 1 + static_cast<std::size_t>(length);
        }
        if (place != numbers.size())
            cells_place_.fail(fmt::format("{} cells have {} numbers, but the line announces {}; "
                                          "expected equal numbers; correct the line",
                                          cells, place, numbers.size()));
    }

    /// Cell data follow the lists in this order, whatever the order in the file.
    void join_lists() {
        for (const auto& list : lists_) {
            const auto begin = static_cast<double>(arrays_.corners.size());
            arrays_.corners.insert(arrays_.corners.end(), list.corners.begin(), list.corners.end());
            for (const double end : list.ends) {
                arrays_.ends.push_back(begin + end);
                arrays_.types.push_back(list.type);
            }
        }
    }

    /// Data of points and of cells. After the tags, and after what is not known, the rest is of no
    /// interest.
    bool read_attribute(const Scanner& place, const std::string& keyword) {
        bool known = true;
        if (keyword == "field") {
            known = read_field();
        } else if (keyword == "scalars") {
            known = read_scalars();
        } else if (keyword == "lookup_table") {
            scanner_.word("the name of a table");
            source_.values(type_of_colors(), 4 * source_.size("colors"));
        } else if (keyword == "color_scalars") {
            scanner_.word("the name of an array");
            source_.values(type_of_colors(), source_.size("colors") * entries());
        } else {
            known = read_vectors(keyword);
        }
        const bool has_points = !arrays_.points.empty() || (has_grid() && grid_.points[0] > 0);
        if (!known && (!has_points || cells_place_.line() == 1))
            place.fail(fmt::format("found {} before the points or cells; expected POINTS, CELLS, "
                                   "POLYGONS or other keywords of a grid; check the format",
                                   quote_word(keyword)));
        if (!known)
            warnings_.push_back(fmt::format("left out everything after {} in line {}",
                                            quote_word(keyword), place.line()));
        return known && arrays_.tags.empty();
    }

    NumberType type_of_colors() const {
        return source_.is_binary() ? NumberType::uint8 : NumberType::float32;
    }

    std::size_t entries() const { return in_cell_data_ ? cell_data_ : point_data_; }

    bool read_array(std::string_view name, std::size_t values, std::string_view type_name) {
        const auto type = VtkSource::type_of(type_name);
        if (!type)
            return source_.skip(type_name, values);
        auto numbers = source_.values(*type, values);
        if (in_cell_data_ && is_tag_name(name))
            arrays_.tags = std::move(numbers);
        return true;
    }

    /// Named arrays, each with a size of its own; they may also stand in front of the points.
    bool read_field() {
        scanner_.word("the name of a field");
        const std::size_t arrays = source_.size("arrays");
        for (std::size_t array = 0; array < arrays;) {
            const auto name = scanner_.word("the name of an array");
            if (name == "METADATA") {
                source_.skip_metadata();
                continue;
            }
            const auto columns = source_.size("columns");
            const auto rows = source_.size("rows");
            if (!read_array(name, columns * rows, scanner_.word("a type of numbers")))
                return false;
            ++array;
        }
        return true;
    }

    bool read_scalars() {
        const auto name = scanner_.word("the name of an array");
        const auto type = scanner_.word("a type of numbers");
        const bool has_columns = !scanner_.at_line_end() && !comes_lookup_table();
        const auto columns = has_columns ? source_.size("columns") : std::size_t{1};

        // The table of colors is named in a line of its own, which old files leave out.
        if (comes_lookup_table()) {
            scanner_.word("LOOKUP_TABLE");
            scanner_.word("the name of a table");
        }
        return read_array(name, columns * entries(), type);
    }

    bool comes_lookup_table() const {
        Scanner ahead = scanner_;
        return !ahead.at_end() && lower_case(ahead.word("LOOKUP_TABLE")) == "lookup_table";
    }

    bool read_vectors(const std::string& keyword) {
        constexpr std::array<std::pair<const char*, std::size_t>, 6> columns{{{"vectors", 3},
                                                                              {"normals", 3},
                                                                              {"tensors", 9},
                                                                              {"tensors6", 6},
                                                                              {"global_ids", 1},
                                                                              {"pedigree_ids", 1}}};
        const auto found =
            std::find_if(columns.begin(), columns.end(),
                         [&keyword](const auto& one) { return keyword == one.first; });
        if (found == columns.end() && keyword != "texture_coordinates")
            return false;
        const auto name = scanner_.word("the name of an array");
        const auto each = found == columns.end() ? source_.size("columns") : found->second;
        return read_array(name, each * entries(), scanner_.word("a type of numbers"));
    }

    const SourceFile& file_;
    VtkSource source_;
    Scanner& scanner_ = source_.scanner();
    Scanner cells_place_;
    std::string kind_;
    VtkGrid grid_;
    std::array<double, 3> origin_{}, spacing_{1, 1, 1};
    bool has_offsets_ = false;
    bool in_cell_data_ = false;
    std::size_t cell_data_ = 0, point_data_ = 0;
    VtkArrays arrays_;
    std::array<List, 4> lists_{List{"vertices", 2, {}, {}}, List{"lines", 4, {}, {}},
                               List{"polygons", 7, {}, {}}, List{"triangle_strips", 6, {}, {}}};
    std::vector<std::string> warnings_;
};

} // namespace

Mesh read_vtk(const SourceFile& file) {
    return VtkReader(file).read();
}

} // namespace polydec
