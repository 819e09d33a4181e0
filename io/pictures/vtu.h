// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace polydec {

/// The VTK cell types that polydec writes, with VTK's numbers.
enum class VtuCell : std::uint8_t {
    vertex = 1,
    line = 3,
    triangle = 5,
    polygon = 7,
    quad = 9,
    tetra = 10,
    hexahedron = 12,
    polyhedron = 42,
};

/// A named array with `components` numbers for each point or each cell.
struct VtuArray {
    std::string name;
    std::variant<std::vector<double>, std::vector<Index>> values;
    int components = 1;     ///< 1, or 3 for vectors
    std::string about = {}; ///< description for readers of a page, with "in units of .." if known
    /// In field data: one entry for each cell of this degree, of the mesh that is shown.
    int degree = -1;

    /// Total count over all components.
    std::size_t size() const {
        return std::visit([](const auto& all) { return all.size(); }, values);
    }

    /// Whether another one has the same name, number of components and kind of numbers.
    bool is_like(const VtuArray& other) const {
        return name == other.name && components == other.components &&
               values.index() == other.values.index();
    }
};

/// Arrays of all points, of all cells, and of the whole.
struct VtuData {
    std::vector<VtuArray> point_data = {};
    std::vector<VtuArray> cell_data = {};
    std::vector<VtuArray> field_data = {}; ///< of any length: eigenvalues, a residual, ..
};
inline constexpr std::array vtu_lists{&VtuData::point_data, &VtuData::cell_data,
                                      &VtuData::field_data};

/// The contents of a VTU file. Append cells with `add_cell` and `add_polyhedron`.
struct VtuGrid : VtuData {
    Points points; ///< N <= 3 columns; missing ones are written as zeros
    std::vector<VtuCell> types;
    std::vector<Index> corners;        ///< point numbers of the cells, one after the other
    std::vector<std::int64_t> offsets; ///< for each cell, end of its corners
    std::vector<Index> faces; ///< for each polyhedron the number of faces, then for each face its
                              ///< number of corners and its corners
    std::vector<std::int64_t> face_offsets; ///< for each cell, end of its faces; -1 without faces
};

/// The precision of coordinates and of point and cell values in the file.
enum class VtuNumbers { float64, float32 };

struct VtuOptions {
    VtuNumbers numbers = VtuNumbers::float64;
};

/// Appends a cell of a type with a fixed number of corners, or a polygon, corners in cyclic order.
void add_cell(VtuGrid& grid, VtuCell type, std::span<const Index> corners);

/// Appends a polygon, corners in cyclic order, as a triangle or quadrangle if it is one, else as a
/// polygon.
void add_polygon(VtuGrid& grid, std::span<const Index> corners);

/// Appends a polyhedron by its faces, each a list of points in cyclic order.
void add_polyhedron(VtuGrid& grid, const std::vector<std::vector<Index>>& faces);

/// A point or cell array of scalars, or of vectors: rows of two or three numbers; two are padded
/// with 0. Throws InvalidInput, naming the array, for other rows.
VtuArray vtu_array(std::string name, const Eigen::Ref<const DenseMatrix>& values);

/// Throws InvalidInput like write_vtu, without writing to the path.
void check_grid(const std::filesystem::path& path, const VtuGrid& grid,
                const VtuOptions& options = {});

/// Writes the grid as VTK's XML UnstructuredGrid (.vtu): binary arrays in base64, inline. Integers
/// are Int32 where they fit. Field data keep all digits. The file appears whole or not at all, and
/// is the same for the same grid. Throws InvalidInput, naming cell, array or entry, if corners are
/// out of range or of the wrong number, an array has the wrong size or a name that is empty or
/// repeated, or a value is NaN, infinite or too large for its type; IoError if writing fails.
void write_vtu(const std::filesystem::path& path, const VtuGrid& grid,
               const VtuOptions& options = {});

/// Throws InvalidInput unless a list in XML, .pvtu or .pvd, can hold files named after this one.
void check_lists_files(const std::filesystem::path& path);

/// Writes VTK's XML PUnstructuredGrid (.pvtu): the list of .vtu files that form one picture, by
/// their paths from its own folder, all with the arrays of this grid. The file appears whole or not
/// at all. Throws IoError if writing fails.
void write_pvtu(const std::filesystem::path& path, const VtuGrid& one,
                const std::vector<std::string>& pieces, const VtuOptions& options = {});

} // namespace polydec
