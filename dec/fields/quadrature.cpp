// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "dec/fields/de_rham.h"
#include "dec/metric/subsets.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <vector>

namespace polydec {

namespace {

/// All lists of `places` numbers >= 0 with the given sum, in lexicographic order: the gaps between
/// bars that are set among so many stars.
std::vector<std::vector<int>> compositions(int places, int sum) {
    auto lists = subsets(sum + places - 1, places - 1);
    for (auto& list : lists) {
        list.push_back(sum + places - 1);
        for (int i = places - 1; i > 0; --i)
            list[i] -= list[i - 1] + 1;
    }
    return lists;
}

/// (-1)^i 4^-s (d + k - 2i)^d k! / (i! (d + k - i)!) with d = 2s+1: as many factors in the
/// numerator as in the denominator, multiplied in turns to avoid overflow.
double weight(int k, int s, int i) {
    const int d = 2 * s + 1;
    double result = i % 2 == 0 ? 1 : -1;
    for (int factor = 1; factor <= d; ++factor)
        result *= double(d + k - 2 * i) / (factor <= i ? factor : k + factor - i);
    for (int half = 0; half < s; ++half)
        result /= 4;
    return result;
}

/// The share of the sum of weights that rounding of values takes. There are as many points of each
/// weight as lists of k + 1 numbers with the sum s - i.
double rounding_share(int k, int s) {
    double lists = 1, sizes = 0, sum = 0;
    for (int i = s; i >= 0; --i) {
        sizes += lists * std::abs(weight(k, s, i));
        sum += lists * weight(k, s, i);
        lists *= double(k + 1 + s - i) / (s - i + 1);
    }
    return std::numeric_limits<double>::epsilon() * sizes / std::abs(sum);
}

} // namespace

SimplexQuadrature grundmann_moeller(int k, int degree) {
    if (k < 0 || degree < 0)
        throw InvalidInput(fmt::format("a quadrature rule of degree {} on simplices of dimension "
                                       "{} does not exist: expected numbers of at least 0",
                                       degree, k));
    // on a vertex one point is exact
    const int s = k == 0 ? 0 : degree / 2;
    for (int lower = 0; lower <= s; ++lower)
        if (!(rounding_share(k, lower) <= 1e-9))
            throw InvalidInput(fmt::format(
                "a quadrature rule of degree {} on simplices of dimension {}: the weights cancel "
                "too much; expected at most {}",
                degree, k, 2 * lower - 1));
    std::vector<std::vector<int>> points;
    std::vector<double> weights;
    for (int i = 0; i <= s; ++i) {
        const auto lists = compositions(k + 1, s - i);
        points.insert(points.end(), lists.begin(), lists.end());
        weights.resize(points.size(), weight(k, s, i));
    }

    SimplexQuadrature rule{DenseMatrix(points.size(), k + 1), Vector(points.size())};
    for (std::size_t q = 0; q < points.size(); ++q) {
        rule.weights[q] = weights[q];
        for (int c = 0; c <= k; ++c)
            rule.points(q, c) = 2 * points[q][c] + 1;
        rule.points.row(q) /= rule.points.row(q).sum();
    }
    return rule;
}

} // namespace polydec
