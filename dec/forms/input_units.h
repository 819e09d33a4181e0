// SPDX-License-Identifier: MIT
#pragma once

#include "dec/stars/star.h"
#include "meshes/unit_of_length.h"

#include <type_traits>

namespace polydec {

/// Volumes and stars converted from a unit of length to the units of the input (see Cells::unit).
/// Throw InvalidInput, naming the degree, for overflow or underflow.
CellVolumes in_input_units(const CellVolumes& volumes, double unit);
HodgeStars in_input_units(const HodgeStars& stars, double unit);

/// The same for a matrix in units of length^power. Throws InvalidInput, naming `what`.
SparseMatrix in_input_units(SparseMatrix matrix, double unit, double power, std::string_view what);

/// Applies form_in_input_units to each column of a table.
template <class Rows>
Rows in_input_units(Rows rows, double unit, double power,
                    std::string_view what) requires(Rows::ColsAtCompileTime == Eigen::Dynamic &&
                                                    !std::is_same_v<Rows, SparseMatrix>) {
    for (auto column : rows.colwise())
        column = form_in_input_units(Vector(column), unit, power, what);
    return rows;
}

} // namespace polydec
