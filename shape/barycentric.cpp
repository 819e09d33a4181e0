// SPDX-License-Identifier: MIT
#include "shape/barycentric.h"

#include <algorithm>

namespace polydec {

long double mean_of_product(int n, std::initializer_list<int> corners) {
    long double mean = 1;
    int before = 0;
    for (auto corner = corners.begin(); corner != corners.end(); ++corner) {
        const auto power = std::count(corners.begin(), corner, *corner) + 1;
        mean *= static_cast<long double>(power) / (n + ++before);
    }
    return mean;
}

std::vector<Pair> quadratic_pairs(int n) {
    std::vector<Pair> pairs;
    for (int i = 0; i <= n; ++i)
        for (int j = i; j <= n; ++j)
            pairs.push_back({i, j});
    return pairs;
}

LongMatrix quadratic_products(int n, const std::vector<Pair>& pairs) {
    const auto size = static_cast<Eigen::Index>(pairs.size());
    LongMatrix products(size, size);
    for (Eigen::Index p = 0; p < size; ++p)
        for (Eigen::Index q = 0; q < size; ++q)
            products(p, q) =
                mean_of_product(n, {pairs[p][0], pairs[p][1], pairs[q][0], pairs[q][1]});
    return products;
}

std::array<Pair, 2> gradient_terms(const Pair& pair) {
    return {Pair{pair[0], pair[1]}, Pair{pair[1], pair[0]}};
}

} // namespace polydec
