// SPDX-License-Identifier: MIT
#include "base/row_sum_norm.h"

#include <algorithm>
#include <cmath>

namespace polydec {

double row_sum_norm(const SparseMatrix& A) {
    double norm = 0;
    for (Eigen::Index i = 0; i < A.rows(); ++i) {
        double sum = 0;
        for (SparseMatrix::InnerIterator entry(A, i); entry; ++entry)
            sum += std::abs(entry.value());
        norm = std::max(norm, sum);
    }
    return norm;
}

double largest_entry(const SparseMatrix& A) {
    return A.nonZeros() > 0 ? A.coeffs().abs().maxCoeff() : 0;
}

} // namespace polydec
