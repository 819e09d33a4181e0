// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization/discretization.h"

#include <functional>
#include <string_view>
#include <vector>

namespace polydec {

/// Number of vertices: all vertices of the input, used by cells or not, followed by the vertices
/// that splits have added. Forms, fields and points() have rows for the 0-cells only, that is, for
/// the vertices that cells use.
Index count_vertices(const Discretization& mesh);

/// For each 0-cell its vertex, ascending.
std::vector<Index> vertices_of_cells(const Discretization& mesh);

/// For each of these vertices its 0-cell. Throws InvalidInput, naming `what` and the vertex, for a
/// number out of range, and for a vertex that no cell uses.
std::vector<Index> cells_of_vertices(const Discretization& mesh, std::string_view what,
                                     const std::vector<Index>& vertices);

/// Range that the values of a quantity must lie in.
enum class Range { positive, not_negative };

/// Numbers for the n-cells of a mesh, such as conductivities.
class CellData {
public:
    /// No data.
    CellData() = default;

    /// One number per cell of the input, in the input's order: per simplex of the given mesh, or
    /// per polygon or solid if those were split (see InputCells). Cells that were left out count
    /// too.
    template <class Numbers>
    CellData(const Eigen::MatrixBase<Numbers>& of_input) : values_(of_input) {}

    /// One number per n-cell of complex(), in its order, e.g. a function at cell_centroids.
    static CellData on_cells(Vector values);

    bool is_empty() const { return values_.size() == 0; }

    /// One number per n-cell. Throws InvalidInput, naming the quantity and the cell of the input:
    /// for a wrong number of values; for a value that is out of range or not finite; and if a cell
    /// joins cells of the input with different values.
    Vector on(const Discretization& mesh, std::string_view what, Range range) const;

private:
    Vector values_;
    bool are_on_cells_ = false;
};

/// Number of cells of the input, one per datum; 0 if the mesh was assembled from parts.
Index count_input_cells(const Discretization& mesh);

/// For each n-cell, the first cell of the input that is part of it. Throws InvalidInput, naming
/// both cells, if the data of another part differ from the first: flips may join any two cells.
std::vector<Index> cells_of_input(const Discretization& mesh, std::string_view what,
                                  const std::function<bool(Index, Index)>& differ);

} // namespace polydec
