// SPDX-License-Identifier: MIT
#include "meshes/edges.h"

#include "base/lists.h"

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
    sort_unique(result);
    return result;
}

std::vector<Index> used_vertices(const Simplices& simplices) {
    std::vector<Index> result(simplices.data(), simplices.data() + simplices.size());
    sort_unique(result);
    return result;
}

} // namespace polydec
