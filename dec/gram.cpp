// SPDX-License-Identifier: MIT
#include "dec/gram.h"

#include "base/errors.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace polydec {

namespace {

/// Calls visit(column, weight) for every contribution to a row of the product.
template <class Visit>
void for_each_term(const IncidenceMatrix& A, const IncidenceMatrix& transposed,
                   const Vector& weights, Index row, Visit visit) {
    const Index *begin = A.outerIndexPtr(), *across = A.innerIndexPtr();
    const Index *first = transposed.outerIndexPtr(), *column = transposed.innerIndexPtr();
    for (Index e = begin[row]; e < begin[row + 1]; ++e) {
        const Index c = across[e];
        const double weight = A.valuePtr()[e] * weights[c];
        for (Index f = first[c]; f < first[c + 1]; ++f)
            visit(column[f], transposed.valuePtr()[f] * weight);
    }
}

/// Where the rows of the product begin.
void count_rows(const IncidenceMatrix& A, const IncidenceMatrix& transposed, const Vector& weights,
                SparseMatrix& product) {
    std::vector<Index> seen_in(static_cast<std::size_t>(product.cols()), -1);
    std::int64_t count = 0;
    for (Index row = 0; row < product.rows(); ++row) {
        for_each_term(A, transposed, weights, row, [&](Index column, double) {
            count += seen_in[column] != row;
            seen_in[column] = row;
        });
        if (count > std::numeric_limits<Index>::max())
            throw InvalidInput("a Laplacian has more than 2^31 - 1 entries");
        product.outerIndexPtr()[row + 1] = static_cast<Index>(count);
    }
    product.resizeNonZeros(count);
}

} // namespace

SparseMatrix gram(const IncidenceMatrix& A, const IncidenceMatrix& transposed,
                  const Vector& weights) {
    SparseMatrix product(A.rows(), A.rows());
    count_rows(A, transposed, weights, product);

    Vector sum(product.cols());
    std::vector<Index> seen_in(static_cast<std::size_t>(product.cols()), -1);
    for (Index row = 0; row < product.rows(); ++row) {
        Index* const columns = product.innerIndexPtr() + product.outerIndexPtr()[row];
        Index* end = columns;
        for_each_term(A, transposed, weights, row, [&](Index column, double value) {
            if (seen_in[column] == row) {
                sum[column] += value;
                return;
            }
            seen_in[column] = row;
            sum[column] = value;
            *end++ = column;
        });
        std::sort(columns, end);
        double* value = product.valuePtr() + product.outerIndexPtr()[row];
        for (const Index* column = columns; column < end; ++column)
            *value++ = sum[*column];
    }
    return product;
}

} // namespace polydec
