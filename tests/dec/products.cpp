// SPDX-License-Identifier: MIT
#include "tests/dec/products.h"

#include "dec/metric/subsets.h"

namespace polydec::test {

namespace {

Index position(const std::vector<std::vector<int>>& lists, const std::vector<int>& list) {
    return static_cast<Index>(std::find(lists.begin(), lists.end(), list) - lists.begin());
}

} // namespace

Cochain random_form(const CellComplex& complex, Side side, int degree, unsigned seed) {
    return {side, degree, random_vector(complex.size(cell_degree(complex, side, degree)), seed)};
}

Vector exterior_product(Index N, int k, const Vector& a, int l, const Vector& b) {
    const auto first = subsets(int(N), k), second = subsets(int(N), l),
               both = subsets(int(N), k + l);
    Vector result = Vector::Zero(Index(both.size()));
    for (std::size_t I = 0; I < first.size(); ++I)
        for (std::size_t J = 0; J < second.size(); ++J) {
            std::vector<int> axes = first[I];
            axes.insert(axes.end(), second[J].begin(), second[J].end());
            Index exchanges = 0;
            for (auto later = axes.begin(); later != axes.end(); ++later)
                exchanges +=
                    std::count_if(axes.begin(), later, [&](int axis) { return axis > *later; });
            std::sort(axes.begin(), axes.end());
            if (std::adjacent_find(axes.begin(), axes.end()) == axes.end())
                result[position(both, axes)] += (exchanges % 2 == 0 ? 1 : -1) * a[I] * b[J];
        }
    return result;
}

Vector contraction(const Vector& x, int k, const Vector& a) {
    const auto N = static_cast<int>(x.size());
    const auto from = subsets(N, k), to = subsets(N, k - 1);
    Vector result = Vector::Zero(Index(to.size()));
    for (std::size_t I = 0; I < from.size(); ++I)
        for (int p = 0; p < k; ++p) {
            auto rest = from[I];
            rest.erase(rest.begin() + p);
            result[position(to, rest)] += (p % 2 == 0 ? 1 : -1) * x[from[I][p]] * a[I];
        }
    return result;
}

} // namespace polydec::test
