// SPDX-License-Identifier: MIT
#include "io/pictures/vtu.h"

#include "base/checks.h"
#include "base/errors.h"
#include "io/base64.h"
#include "io/pictures/vtu_solids.h"
#include "io/source_file.h"
#include "io/xml_text.h"
#include "system/atomic_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

namespace polydec {

namespace {

/// How many corners a cell may have.
bool corners_fit(VtuCell type, std::int64_t corners) {
    switch (type) {
    case VtuCell::vertex:
        return corners == 1;
    case VtuCell::line:
        return corners == 2;
    case VtuCell::triangle:
        return corners == 3;
    case VtuCell::quad:
    case VtuCell::tetra:
        return corners == 4;
    case VtuCell::polygon:
        return corners >= 3;
    case VtuCell::hexahedron:
        return corners == 8;
    case VtuCell::polyhedron:
        return corners >= 4;
    }
    return false;
}

class Checker {
public:
    Checker(const std::filesystem::path& path, const VtuGrid& grid, const VtuOptions& options)
        : path_(path),
          grid_(grid),
          largest_(options.numbers == VtuNumbers::float32 ? std::numeric_limits<float>::max()
                                                          : std::numeric_limits<double>::max()) {}

    void check() const {
        check_points();
        check_sizes();
        std::int64_t begin = 0;
        std::int64_t faces_begin = 0;
        for (std::size_t cell = 0; cell < grid_.types.size(); ++cell) {
            check_cell(cell, begin, faces_begin);
            begin = grid_.offsets[cell];
            faces_begin = std::max(faces_begin, grid_.face_offsets[cell]);
        }
        check_arrays(grid_.point_data, static_cast<std::size_t>(grid_.points.rows()), "points");
        check_arrays(grid_.cell_data, grid_.types.size(), "cells");
        check_arrays(grid_.field_data, std::nullopt, "the whole");
    }

private:
    void check_points() const {
        if (grid_.points.cols() > 3)
            refuse("VTU holds points of R^3, not of R^{}; project them first", grid_.points.cols());
        for (Eigen::Index point = 0; point < grid_.points.rows(); ++point) {
            if (!grid_.points.row(point).allFinite())
                refuse("point {} has a coordinate that is NaN or infinite; correct it", point);
            if (!(grid_.points.row(point).array().abs() <= largest_).all())
                refuse("point {} has a coordinate that Float32 cannot hold; write Float64", point);
        }
    }

    void check_sizes() const {
        const auto cells = grid_.types.size();
        const bool same = grid_.offsets.size() == cells && grid_.face_offsets.size() == cells;
        const auto last = grid_.offsets.empty() ? 0 : grid_.offsets.back();
        if (!same || last != static_cast<std::int64_t>(grid_.corners.size()))
            refuse("types, offsets and corners of the cells do not match; append cells with "
                   "add_cell and add_polyhedron");
    }

    void check_cell(std::size_t cell, std::int64_t begin, std::int64_t faces_begin) const {
        const auto end = grid_.offsets[cell];
        const auto all = static_cast<std::int64_t>(grid_.corners.size());
        if (end < begin || end > all || !corners_fit(grid_.types[cell], end - begin))
            refuse("cell {} of VTK's type {} has {} corners; give it the corners of its type", cell,
                   static_cast<int>(grid_.types[cell]), end - begin);
        for (auto i = begin; i < end; ++i)
            check_corner(cell, grid_.corners[i]);

        const bool has_faces = grid_.face_offsets[cell] >= 0;
        if (has_faces != (grid_.types[cell] == VtuCell::polyhedron))
            refuse("cell {}: polyhedra have faces, other cells have none; append it with add_cell "
                   "or add_polyhedron",
                   cell);
        if (has_faces)
            check_faces(cell, faces_begin);
    }

    void check_corner(std::size_t cell, Index corner) const {
        if (corner < 0 || corner >= grid_.points.rows())
            refuse("cell {} has the point {}; {}", cell, corner,
                   expected_numbers(0, grid_.points.rows() - 1));
    }

    void check_faces(std::size_t cell, std::int64_t begin) const {
        const auto faces = polyhedron_faces(grid_.faces, begin, grid_.face_offsets[cell]);
        if (!faces)
            refuse("the faces of polyhedron {} do not fit together; append it with add_polyhedron, "
                   "with at least 3 corners a face",
                   cell);
        for (const auto& face : *faces)
            for (const Index corner : face)
                check_corner(cell, corner);
    }

    template <typename... Args>
    [[noreturn]] void refuse(fmt::format_string<Args...> text, Args&&... args) const {
        refuse_writing(path_, fmt::format(text, std::forward<Args>(args)...));
    }

    /// Without a number of entries any will do.
    void check_arrays(const std::vector<VtuArray>& arrays, std::optional<std::size_t> count,
                      const char* plural) const {
        std::set<std::string_view> names;
        for (const auto& array : arrays) {
            const bool control = std::any_of(array.name.begin(), array.name.end(),
                                             [](char c) { return c >= 0 && c < ' '; });
            if (array.name.empty() || control || !names.insert(array.name).second)
                refuse("the name '{}' of an array of {} is empty, not printable or not unique; "
                       "choose another",
                       control ? "?" : array.name, plural);
            check_array(array, count, plural);
            check_numbers(array, count ? largest_ : std::numeric_limits<double>::max(), plural);
        }
    }

    void check_array(const VtuArray& array, std::optional<std::size_t> count,
                     const char* plural) const {
        const auto size = array.size();
        const auto components = static_cast<std::size_t>(array.components);
        if ((components != 1 && components != 3) ||
            size != count.value_or(size / components) * components)
            refuse("the array '{}' has {} values of {} components; expected {}", array.name, size,
                   array.components,
                   count ? fmt::format("one entry of 1 or 3 components for each of {} {}", *count,
                                       plural)
                         : "entries of 1 or 3 components");
    }

    void check_numbers(const VtuArray& array, double largest, const char* plural) const {
        const auto* numbers = std::get_if<std::vector<double>>(&array.values);
        for (std::size_t i = 0; numbers != nullptr && i < numbers->size(); ++i) {
            const double number = (*numbers)[i];
            const auto entry = i / static_cast<std::size_t>(array.components);
            if (!std::isfinite(number))
                refuse("the array '{}' of {} is NaN or infinite in entry {}; correct it",
                       array.name, plural, entry);
            if (!(std::abs(number) <= largest))
                refuse("the array '{}' of {} has {} in entry {}, which Float32 cannot hold; write "
                       "Float64",
                       array.name, plural, number, entry);
        }
    }

    const std::filesystem::path& path_;
    const VtuGrid& grid_;
    double largest_; ///< number that can be written
};

template <typename Number>
constexpr const char* type_name = nullptr;
template <>
constexpr const char* type_name<double> = "Float64";
template <>
constexpr const char* type_name<float> = "Float32";
template <>
constexpr const char* type_name<std::int64_t> = "Int64";
template <>
constexpr const char* type_name<Index> = "Int32";
template <>
constexpr const char* type_name<std::uint8_t> = "UInt8";

/// Writes the parts of one file.
class Writer {
public:
    Writer(AtomicFile& file, VtuNumbers numbers) : file_(file), numbers_(numbers) {}

    void points(const Points& points) {
        std::vector<double> padded(static_cast<std::size_t>(points.rows()) * 3, 0.0);
        for (Eigen::Index point = 0; point < points.rows(); ++point)
            for (Eigen::Index axis = 0; axis < points.cols(); ++axis)
                padded[3 * point + axis] = points(point, axis);
        file_.write("<Points>\n");
        reals("Points", columns(3), padded);
        file_.write("</Points>\n");
    }

    void cells(const VtuGrid& grid) {
        std::vector<std::uint8_t> types;
        types.reserve(grid.types.size());
        for (const auto type : grid.types)
            types.push_back(static_cast<std::uint8_t>(type));
        file_.write("<Cells>\n");
        array("connectivity", "", grid.corners);
        ends("offsets", grid.offsets, grid.corners.size());
        array("types", "", types);
        if (!grid.faces.empty()) {
            array("faces", "", grid.faces);
            ends("faceoffsets", grid.face_offsets, grid.faces.size());
        }
        file_.write("</Cells>\n");
    }

    void data(const char* tag, const std::vector<VtuArray>& arrays) {
        file_.write(fmt::format("<{}>\n", tag));
        for (const auto& each : arrays)
            if (const auto* numbers = std::get_if<std::vector<double>>(&each.values))
                reals(each.name, columns(each.components), *numbers);
            else
                array(each.name, columns(each.components),
                      std::get<std::vector<Index>>(each.values));
        file_.write(fmt::format("</{}>\n", tag));
    }

    /// Data of the whole: VTK has to be told how many entries each array has.
    void field(const std::vector<VtuArray>& arrays) {
        if (arrays.empty())
            return;
        file_.write("<FieldData>\n");
        for (const auto& each : arrays)
            std::visit(
                [&](const auto& values) {
                    const auto count = values.size() / static_cast<std::size_t>(each.components);
                    array(each.name,
                          columns(each.components) + fmt::format(" NumberOfTuples=\"{}\"", count),
                          values);
                },
                each.values);
        file_.write("</FieldData>\n");
    }

private:
    /// The number 1 is the default, and spelled out some readers take it for a table of one column.
    static std::string columns(int components) {
        return components > 1 ? fmt::format(" NumberOfComponents=\"{}\"", components) : "";
    }

    /// In front of the numbers stands how many bytes they take.
    template <typename Number>
    void array(std::string_view name, const std::string& more, const std::vector<Number>& values) {
        file_.write(fmt::format("<DataArray type=\"{}\" Name=\"{}\"{} format=\"binary\">\n",
                                type_name<Number>, xml_escaped(name), more));
        Base64Writer writer([this](std::string_view text) { file_.write(text); });
        writer.write(std::uint64_t{values.size() * sizeof(Number)});
        writer.write(std::span<const Number>(values));
        writer.finish();
        file_.write("\n</DataArray>\n");
    }

    void reals(std::string_view name, const std::string& more, const std::vector<double>& values) {
        if (numbers_ == VtuNumbers::float32)
            array(name, more, std::vector<float>(values.begin(), values.end()));
        else
            array(name, more, values);
    }

    void ends(std::string_view name, const std::vector<std::int64_t>& values, std::size_t last) {
        if (last <= static_cast<std::size_t>(std::numeric_limits<Index>::max()))
            array(name, "", std::vector<Index>(values.begin(), values.end()));
        else
            array(name, "", values);
    }

    AtomicFile& file_;
    VtuNumbers numbers_;
};

} // namespace

void add_cell(VtuGrid& grid, VtuCell type, std::span<const Index> corners) {
    grid.types.push_back(type);
    grid.corners.insert(grid.corners.end(), corners.begin(), corners.end());
    grid.offsets.push_back(static_cast<std::int64_t>(grid.corners.size()));
    grid.face_offsets.push_back(-1);
}

void add_polygon(VtuGrid& grid, std::span<const Index> corners) {
    const auto size = corners.size();
    add_cell(grid,
             size == 3   ? VtuCell::triangle
             : size == 4 ? VtuCell::quad
                         : VtuCell::polygon,
             corners);
}

void add_polyhedron(VtuGrid& grid, const std::vector<std::vector<Index>>& faces) {
    std::set<Index> corners;
    grid.faces.push_back(static_cast<Index>(faces.size()));
    for (const auto& face : faces) {
        grid.faces.push_back(static_cast<Index>(face.size()));
        grid.faces.insert(grid.faces.end(), face.begin(), face.end());
        corners.insert(face.begin(), face.end());
    }
    add_cell(grid, VtuCell::polyhedron, std::vector(corners.begin(), corners.end()));
    grid.face_offsets.back() = static_cast<std::int64_t>(grid.faces.size());
}

VtuArray vtu_array(std::string name, const Eigen::Ref<const DenseMatrix>& values) {
    if (values.cols() < 1 || values.cols() > 3)
        throw InvalidInput(fmt::format("the array `{}` has rows of {} numbers: expected 1, or 2 or "
                                       "3 for vectors",
                                       name, values.cols()));
    const int components = values.cols() == 1 ? 1 : 3;
    std::vector<double> numbers;
    numbers.reserve(static_cast<std::size_t>(values.rows()) * components);
    for (Eigen::Index i = 0; i < values.rows(); ++i)
        for (int c = 0; c < components; ++c)
            numbers.push_back(c < values.cols() ? values(i, c) : 0);
    return {std::move(name), std::move(numbers), components};
}

void check_grid(const std::filesystem::path& path, const VtuGrid& grid, const VtuOptions& options) {
    Checker(path, grid, options).check();
}

void write_vtu(const std::filesystem::path& path, const VtuGrid& grid, const VtuOptions& options) {
    check_grid(path, grid, options);
    AtomicFile file(path);
    file.write("<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
               "byte_order=\"LittleEndian\" header_type=\"UInt64\">\n<UnstructuredGrid>\n");
    Writer writer(file, options.numbers);
    writer.field(grid.field_data);
    file.write(fmt::format("<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n",
                           grid.points.rows(), grid.types.size()));
    writer.points(grid.points);
    writer.cells(grid);
    writer.data("PointData", grid.point_data);
    writer.data("CellData", grid.cell_data);
    file.write("</Piece>\n</UnstructuredGrid>\n</VTKFile>\n");
    file.commit();
}

} // namespace polydec
