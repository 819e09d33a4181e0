// SPDX-License-Identifier: MIT
#include "meshes/edges.h"

#include <algorithm>

namespace polydec {

std::vector<Edge> edges_of(const Simplices& simplices) {
    std::vector<Edge> result;
    for (Index s = 0; s < simplices.rows(); ++s)
        for (Index i = 0; i < simplices.cols(); ++i)
            for (Index j = i + 1; j < simplices.cols(); ++j)
                if (simplices(s, i) != simplices(s, j)) // a repeated corner is the complex's matter
                    result.emplace_back(
                        std::minmax(Index{simplices(s, i)}, Index{simplices(s, j)}));
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

} // namespace polydec
