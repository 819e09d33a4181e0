// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

namespace polydec {

/// Sign, 1 or -1, of the permutation that sorts a list into ascending order, stably.
inline double permutation_sign(const std::vector<int>& list) {
    double sign = 1;
    for (std::size_t i = 0; i < list.size(); ++i)
        for (std::size_t j = i + 1; j < list.size(); ++j)
            if (list[j] < list[i])
                sign = -sign;
    return sign;
}

} // namespace polydec
