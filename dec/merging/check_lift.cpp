// SPDX-License-Identifier: MIT
#include "dec/merging/check_lift.h"

#include "base/errors.h"

#include <fmt/format.h>

namespace polydec {

void check_lift(const Merging& merging, const std::vector<SparseMatrix>& lift) {
    const int n = merging.pieces().dimension();
    if (lift.size() != static_cast<std::size_t>(n) + 1)
        throw InvalidInput(fmt::format("a lift of {} matrices is given: expected one for each "
                                       "degree 0 to {}, as commuting_lift makes them",
                                       lift.size(), n));
    for (int k = 0; k <= n; ++k) {
        const Index rows = merging.pieces().size(k), columns = merging.merged().size(k);
        if (lift[k].rows() != rows || lift[k].cols() != columns)
            throw InvalidInput(fmt::format("the lift of degree {} is {} x {}: expected {} x {}, "
                                           "simplices times merged cells of the same merging",
                                           k, lift[k].rows(), lift[k].cols(), rows, columns));
    }
}

} // namespace polydec
