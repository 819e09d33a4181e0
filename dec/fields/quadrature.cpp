// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "dec/fields/de_rham.h"

#include <fmt/format.h>

#include <vector>

namespace polydec {

namespace {

/// Appends all lists of `places` numbers >= 0 with the given sum to the rows begun by `list`.
void compositions(int places, int sum, std::vector<int>& list,
                  std::vector<std::vector<int>>& result) {
    if (places == 1) {
        list.push_back(sum);
        result.push_back(list);
        list.pop_back();
        return;
    }
    for (int first = 0; first <= sum; ++first) {
        list.push_back(first);
        compositions(places - 1, sum - first, list, result);
        list.pop_back();
    }
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

} // namespace

SimplexQuadrature grundmann_moeller(int k, int degree) {
    if (k < 0 || degree < 0)
        throw InvalidInput(fmt::format("a quadrature rule of degree {} on simplices of dimension "
                                       "{} does not exist: expected numbers of at least 0",
                                       degree, k));
    // on a vertex one point is exact
    const int s = k == 0 ? 0 : degree / 2;
    std::vector<std::vector<int>> points;
    std::vector<double> weights;
    std::vector<int> list;
    for (int i = 0; i <= s; ++i) {
        compositions(k + 1, s - i, list, points);
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
