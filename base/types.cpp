// SPDX-License-Identifier: MIT
#include "base/types.h"

#include "base/errors.h"

#include <fmt/format.h>

namespace polydec::detail {

void refuse_as_column(Eigen::Index rows, Eigen::Index columns) {
    throw InvalidInput(fmt::format(
        "expected a vector, not a matrix of {} x {} numbers; pass one column, matrix.col(j)", rows,
        columns));
}

} // namespace polydec::detail
