// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/unit_of_length.h"

#include <type_traits>

namespace polydec {

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
