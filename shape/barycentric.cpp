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

} // namespace polydec
