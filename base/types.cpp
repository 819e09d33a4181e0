// SPDX-License-Identifier: MIT
#include "base/types.h"

#include "base/errors.h"

#include <fmt/format.h>

namespace polydec::detail {

void refuse_as_column(Eigen::Index rows, Eigen::Index columns) {
    throw InvalidInput(fmt::format("a matrix of {} x {} numbers where a vector is expected; hand "
                                   "over one column, matrix.col(j)",
                                   rows, columns));
}

} // namespace polydec::detail
