// SPDX-License-Identifier: MIT
#include "dec/metric/exterior_product.h"

#include "base/lists.h"
#include "dec/metric/subsets.h"

namespace polydec {

ExteriorProduct::ExteriorProduct(int N, int k) : degrees_(1, {{}}) {
    auto lower = subsets(N, 0);
    for (int j = 1; j <= k; ++j) {
        auto current = subsets(N, j);
        degrees_.emplace_back(current.size());
        for (std::size_t J = 0; J < current.size(); ++J)
            for (int p = 0; p < j; ++p) {
                auto rest = current[J];
                rest.erase(rest.begin() + p);
                degrees_[j][J].push_back(
                    {place_in(lower, rest), current[J][p], (j - 1 - p) % 2 == 0 ? 1.0 : -1.0});
            }
        lower = std::move(current);
    }
}

Vector ExteriorProduct::operator()(const DenseMatrix& vectors) const {
    Vector product = Vector::Ones(1);
    for (std::size_t j = 1; j < degrees_.size(); ++j) {
        Vector next = Vector::Zero(static_cast<Index>(degrees_[j].size()));
        for (Index J = 0; J < next.size(); ++J)
            for (const auto& term : degrees_[j][J])
                next[J] += term.sign * product[term.rest] * vectors(j - 1, term.axis);
        product = std::move(next);
    }
    return product;
}

Vector ExteriorProduct::without(int p, std::vector<int> list, const DenseMatrix& rows) const {
    list.erase(list.begin() + p);
    Vector product = (*this)(rows(list, Eigen::indexing::all));
    product *= p % 2 == 0 ? 1 : -1;
    return product;
}

} // namespace polydec
