// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace polydec {

/// The cells of VTK that polydec writes, with VTK's numbers.
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

/// Named values, entry by entry: of each point or of each cell `components` numbers.
struct VtuArray {
    std::string name;
    std::variant<std::vector<double>, std::vector<Index>> values;
    int components = 1;     ///< 1, or 3 for vectors
    std::string about = {}; ///< what they are, in words with units, for who reads a page

    /// Numbers of all components together.
    std::size_t size() const {
        return std::visit([](const auto& all) { return all.size(); }, values);
    }
};

/// What a VTU file holds. Cells are appended with `add_cell` and `add_polyhedron`.
struct VtuGrid {
    Points points; ///< N <= 3 columns; the file has zeros for the missing ones
    std::vector<VtuCell> types;
    std::vector<Index> corners;        ///< point numbers of the cells, one after the other
    std::vector<std::int64_t> offsets; ///< of each cell: where its corners end
    std::vector<Index> faces;          ///< of each polyhedron: number of faces, then of each face
                                       ///< its number of corners and these
    std::vector<std::int64_t> face_offsets; ///< of each cell: where its faces end; -1 without faces
    std::vector<VtuArray> point_data;
    std::vector<VtuArray> cell_data;
    std::vector<VtuArray> field_data; ///< of the whole, of any length: eigenvalues, a residual, ..
};

/// In how many digits coordinates and the values of points and cells are written.
enum class VtuNumbers { float64, float32 };

struct VtuOptions {
    VtuNumbers numbers = VtuNumbers::float64;
};

/// Appends a cell of a type with a fixed number of corners, or a polygon, corners in cyclic order.
void add_cell(VtuGrid& grid, VtuCell type, std::span<const Index> corners);

/// Appends a polygon, corners in cyclic order, as the triangle or quadrangle that it is, or else as
/// a polygon.
void add_polygon(VtuGrid& grid, std::span<const Index> corners);

/// Appends a polyhedron by its faces, each a list of points in cyclic order.
void add_polyhedron(VtuGrid& grid, const std::vector<std::vector<Index>>& faces);

/// A point or cell array of one number each, or of a vector each: a row of two or three numbers, of
/// which two get a third that is 0. Throws InvalidInput, naming the array, for other rows.
VtuArray vtu_array(std::string name, const Eigen::Ref<const DenseMatrix>& values);

/// Throws InvalidInput as write_vtu does, before anything is written to that path.
void check_grid(const std::filesystem::path& path, const VtuGrid& grid,
                const VtuOptions& options = {});

/// Writes the grid as VTK's XML UnstructuredGrid (.vtu): binary arrays in base64, inline.
/// Whole numbers are Int32 where they fit. Data of the whole keep all digits.
/// The file appears whole or not at all, and is the same for the same grid.
/// Throws InvalidInput, naming cell, array or entry, if corners are out of range or of the wrong
/// number, an array has the wrong size or a name that is empty or used twice, or anything is NaN,
/// infinite or larger than the numbers can be; IoError if writing fails.
void write_vtu(const std::filesystem::path& path, const VtuGrid& grid,
               const VtuOptions& options = {});

} // namespace polydec
