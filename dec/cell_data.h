// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"

#include <functional>
#include <string_view>
#include <vector>

namespace polydec {

/// Which numbers a quantity may have.
enum class Range { positive, not_negative };

/// Numbers for the n-cells of a mesh, such as conductivities.
class CellData {
public:
    /// None.
    CellData() = default;

    /// One for each cell of the input, in the input's order: for each simplex of the mesh that was
    /// given, or for each polygon or solid where these were split (see InputCells). Cells that were
    /// left out have one too.
    template <class Numbers>
    CellData(const Eigen::MatrixBase<Numbers>& of_input) : values_(of_input) {}

    /// One for each n-cell of complex(), in its order, such as a function at cell_centroids.
    static CellData on_cells(Vector values);

    bool is_empty() const { return values_.size() == 0; }

    /// One for each n-cell. Throws InvalidInput, saying what they are and naming the cell of the
    /// input, for another number of them, for one out of range or not finite, and where a cell
    /// joins cells of the input with different numbers.
    Vector on(const Discretization& mesh, std::string_view what, Range range) const;

private:
    Vector values_;
    bool are_on_cells_ = false;
};

/// Number of the input's cells, for which data are given; 0 if the mesh was made of parts.
Index count_input_cells(const Discretization& mesh);

/// Of each n-cell the first cell of the input that is part of it. Throws InvalidInput, naming both,
/// where data of another part differ from those of the first: flips may join any cells.
std::vector<Index> cells_of_input(const Discretization& mesh, std::string_view what,
                                  const std::function<bool(Index, Index)>& differ);

} // namespace polydec
