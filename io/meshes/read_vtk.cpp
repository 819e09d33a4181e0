// SPDX-License-Identifier: MIT
#include "io/meshes/readers.h"
#include "io/meshes/vtk_cells.h"
#include "io/number_type.h"
#include "io/scanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>

namespace polydec {

namespace {

using NamedType = std::pair<std::string_view, NumberType>;

/// A vtkIdType is written with 32 bits, whatever it has in memory.
constexpr std::array named_types{NamedType{"char", NumberType::int8},
                                 NamedType{"signed_char", NumberType::int8},
                                 NamedType{"unsigned_char", NumberType::uint8},
                                 NamedType{"short", NumberType::int16},
                                 NamedType{"unsigned_short", NumberType::uint16},
                                 NamedType{"int", NumberType::int32},
                                 NamedType{"unsigned_int", NumberType::uint32},
                                 NamedType{"long", NumberType::int64},
                                 NamedType{"unsigned_long", NumberType::uint64},
                                 NamedType{"vtktypeint64", NumberType::int64},
                                 NamedType{"vtktypeuint64", NumberType::uint64},
                                 NamedType{"vtkidtype", NumberType::int32},
                                 NamedType{"float", NumberType::float32},
                                 NamedType{"double", NumberType::float64}};

/// Keywords may be written in any case.
std::string lower(std::string_view word) {
    std::string result(word);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return result;
}

class VtkReader {
public:
    explicit VtkReader(const SourceFile& file)
        : file_(file), scanner_(file.name, file.text), cells_place_(scanner_) {}

    Mesh read() {
        read_header();
        bool goes_on = true;
        while (goes_on && !scanner_.at_end())
            goes_on = read_section();
        if (is_poly_data_)
            join_lists();
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

    void read_header() {
        const auto mark = scanner_.word("# vtk DataFile Version");
        for (const char* expected : {"vtk", "datafile", "version"}) {
            if (mark != "#" || lower(scanner_.word(expected)) != expected) {
                scanner_.fail("the file does not begin with # vtk DataFile Version; expected a "
                              "legacy VTK file; check the format");
            }
        }
        const double version = scanner_.number("the version");
        if (!(version >= 1.0 && version < 6.0)) {
            scanner_.fail(fmt::format("version {} of the format; expected 1 to 5.1; save the mesh "
                                      "as .vtu",
                                      version));
        }
        has_offsets_ = version >= 5.0;
        scanner_.next_line();
        scanner_.next_line();

        const auto encoding = lower(scanner_.word("ASCII or BINARY"));
        if (encoding != "ascii" && encoding != "binary") {
            scanner_.fail(fmt::format("{} behind the title; expected ASCII or BINARY; correct the "
                                      "third line",
                                      quote_word(encoding)));
        }
        is_binary_ = encoding == "binary";
        read_kind();
    }

    void read_kind() {
        const auto keyword = lower(scanner_.word("DATASET"));
        const auto kind = lower(scanner_.word("the kind of the data set"));
        is_poly_data_ = kind == "polydata";
        if (keyword != "dataset" || !(is_poly_data_ || kind == "unstructured_grid")) {
            scanner_.fail(fmt::format("a data set of the kind {}; expected DATASET "
                                      "UNSTRUCTURED_GRID or DATASET POLYDATA; convert it, for "
                                      "instance with ParaView",
                                      quote_word(kind)));
        }
    }

    /// False at the end of what has to be read.
    bool read_section() {
        const Scanner place = scanner_;
        const auto keyword = lower(scanner_.word("a keyword"));
        const auto list = std::find_if(lists_.begin(), lists_.end(), [&keyword](const List& one) {
            return keyword == one.keyword;
        });
        if (keyword == "points") {
            const auto count = std::size_t{3} * static_cast<std::size_t>(size("points"));
            arrays_.points = read_values(read_type(), count);
        } else if (!is_poly_data_ && keyword == "cells") {
            cells_place_ = place;
            read_cells(arrays_.corners, arrays_.ends);
        } else if (!is_poly_data_ && keyword == "cell_types") {
            const auto count = static_cast<std::size_t>(size("cell types"));
            arrays_.types = read_values(NumberType::int32, count);
        } else if (is_poly_data_ && list != lists_.end()) {
            cells_place_ = place;
            read_cells(list->corners, list->ends);
        } else if (keyword == "cell_data") {
            cell_data_ = static_cast<std::size_t>(size("cells with data"));
            in_cell_data_ = true;
        } else if (keyword == "point_data") {
            point_data_ = static_cast<std::size_t>(size("points with data"));
            in_cell_data_ = false;
        } else if (keyword == "metadata") {
            skip_metadata();
        } else {
            return read_attribute(place, keyword);
        }
        return true;
    }

    Index size(const char* plural) { return scanner_.count(plural, 0); }

    std::optional<NumberType> type_of(std::string_view word) const {
        const auto name = lower(word);
        const auto found =
            std::find_if(named_types.begin(), named_types.end(),
                         [&name](const NamedType& one) { return name == one.first; });
        return found == named_types.end() ? std::nullopt : std::optional(found->second);
    }

    NumberType read_type() {
        const auto word = scanner_.word("a type of numbers");
        const auto type = type_of(word);
        if (!type) {
            scanner_.fail(fmt::format("{} is no type of numbers that is read; expected float, "
                                      "double, int or another of VTK's; export it again",
                                      quote_word(word)));
        }
        return *type;
    }

    /// Numbers that begin behind this line; nothing is allocated that the file cannot hold.
    std::vector<double> read_values(NumberType type, std::size_t count) {
        scanner_.end_line("the line in front of the numbers");
        const auto each = is_binary_ ? size_of(type) : 2;
        if (count > (scanner_.remaining() + 1) / each) {
            scanner_.fail(fmt::format("{} numbers are promised, but {} bytes follow; expected at "
                                      "least {} bytes for each; correct the number, or export "
                                      "again if the file was cut off",
                                      count, scanner_.remaining(), each));
        }
        std::vector<double> values(count);
        if (is_binary_) {
            const auto bytes = scanner_.bytes(count * each, "more numbers");
            for (std::size_t i = 0; i < count; ++i)
                values[i] = value_at(bytes.data() + i * each, type, std::endian::big);
        } else {
            for (auto& value : values)
                value = scanner_.number("a number");
        }
        return values;
    }

    void read_cells(std::vector<double>& corners, std::vector<double>& ends) {
        const Index first = size("cells");
        const Index second = size("numbers of cells");
        corners.clear();
        ends.clear();
        if (has_offsets_) {
            read_offsets(static_cast<std::size_t>(first), ends);
            read_keyword("connectivity");
            const auto type = read_type();
            corners = read_values(type, static_cast<std::size_t>(second));
        } else {
            const auto numbers = read_values(NumberType::int32, static_cast<std::size_t>(second));
            divide(numbers, first, corners, ends);
        }
        const double last = ends.empty() ? 0.0 : ends.back();
        if (last != static_cast<double>(corners.size())) {
            cells_place_.fail(fmt::format("the offsets end with {}, but there are {} corners of "
                                          "cells; expected that number; export it again",
                                          last, corners.size()));
        }
    }

    void read_keyword(const char* expected) {
        const auto word = scanner_.word(expected);
        if (lower(word) != expected) {
            scanner_.fail(fmt::format("{} among the cells; expected {}, as version 5 has it; "
                                      "export it again",
                                      quote_word(word), expected));
        }
    }

    /// Since version 5, offsets are where the corners of a cell begin, and then where all end.
    void read_offsets(std::size_t count, std::vector<double>& ends) {
        read_keyword("offsets");
        ends = read_values(read_type(), count);
        if (!ends.empty()) {
            if (ends.front() != 0.0) {
                scanner_.fail(fmt::format("the offsets begin with {}; expected 0; export it again",
                                          ends.front()));
            }
            ends.erase(ends.begin());
        }
    }

    /// Before, the number of corners stood in front of those of each cell.
    void divide(const std::vector<double>& numbers, Index cells, std::vector<double>& corners,
                std::vector<double>& ends) const {
        std::size_t place = 0;
        for (Index cell = 0; cell < cells; ++cell) {
            const double most =
                static_cast<double>(numbers.size()) - static_cast<double>(place) - 1;
            const double length = place < numbers.size() ? numbers[place] : -1.0;
            if (!(length >= 0.0 && length <= most) ||
                length != static_cast<double>(static_cast<std::size_t>(length))) {
                cells_place_.fail(fmt::format("the {} numbers of cells end within cell {} of {}; "
                                              "expected a number of corners and these for each; "
                                              "correct the line",
                                              numbers.size(), cell, cells));
            }
            const auto begin = numbers.begin() + static_cast<std::ptrdiff_t>(place) + 1;
            corners.insert(corners.end(), begin, begin + static_cast<std::ptrdiff_t>(length));
            ends.push_back(static_cast<double>(corners.size()));
            place += 1 + static_cast<std::size_t>(length);
        }
        if (place != numbers.size()) {
            cells_place_.fail(fmt::format("{} cells take {} numbers, but {} are promised; expected "
                                          "as many; correct the line",
                                          cells, place, numbers.size()));
        }
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

    /// Lines of text up to an empty one.
    void skip_metadata() {
        do {
            scanner_.next_line();
        } while (!scanner_.at_line_end());
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
            const auto colors = static_cast<std::size_t>(size("colors"));
            read_values(is_binary_ ? NumberType::uint8 : NumberType::float32, 4 * colors);
        } else if (keyword == "color_scalars") {
            scanner_.word("the name of an array");
            const auto columns = static_cast<std::size_t>(size("colors"));
            read_values(is_binary_ ? NumberType::uint8 : NumberType::float32, columns * entries());
        } else {
            known = read_vectors(keyword);
        }
        if (!known && (arrays_.points.empty() || cells_place_.line() == 1)) {
            place.fail(fmt::format("{} in front of the points or cells; expected POINTS, CELLS, "
                                   "POLYGONS or other keywords of a grid; check the format",
                                   quote_word(keyword)));
        }
        if (!known) {
            warnings_.push_back(fmt::format("what follows {} in line {} was left out",
                                            quote_word(keyword), place.line()));
        }
        return known && arrays_.tags.empty();
    }

    std::size_t entries() const { return in_cell_data_ ? cell_data_ : point_data_; }

    void keep_tags(std::string_view name, std::vector<double> values) {
        if (in_cell_data_ && is_tag_name(name) && values.size() == cell_data_)
            arrays_.tags = std::move(values);
    }

    bool read_array(std::string_view name, std::size_t values, std::string_view type_name) {
        const auto type = type_of(type_name);
        if (type)
            keep_tags(name, read_values(*type, values));
        return type.has_value();
    }

    /// Named arrays, each with a size of its own; they may also stand in front of the points.
    bool read_field() {
        scanner_.word("the name of a field");
        const Index arrays = size("arrays");
        for (Index array = 0; array < arrays;) {
            const auto name = scanner_.word("the name of an array");
            if (name == "METADATA") {
                skip_metadata();
                continue;
            }
            const auto columns = static_cast<std::size_t>(size("columns"));
            const auto rows = static_cast<std::size_t>(size("rows"));
            if (!read_array(name, columns * rows, scanner_.word("a type of numbers")))
                return false;
            ++array;
        }
        return true;
    }

    bool read_scalars() {
        const auto name = scanner_.word("the name of an array");
        const auto type = scanner_.word("a type of numbers");
        const auto columns =
            scanner_.at_line_end() ? std::size_t{1} : static_cast<std::size_t>(size("columns"));

        // The table of colors is named in a line of its own, which old files leave out.
        Scanner ahead = scanner_;
        if (!ahead.at_end() && lower(ahead.word("LOOKUP_TABLE")) == "lookup_table") {
            ahead.word("the name of a table");
            scanner_ = ahead;
        }
        return read_array(name, columns * entries(), type);
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
        const auto each =
            found == columns.end() ? static_cast<std::size_t>(size("columns")) : found->second;
        return read_array(name, each * entries(), scanner_.word("a type of numbers"));
    }

    const SourceFile& file_;
    Scanner scanner_;
    Scanner cells_place_;
    bool is_binary_ = false;
    bool is_poly_data_ = false;
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
