// SPDX-License-Identifier: MIT
#include "base/block_matrix.h"

#include <cassert>

namespace polydec {

SparseMatrix block_matrix(const SparseMatrix& A, const SparseMatrix& B, const SparseMatrix& D) {
    assert(A.rows() == A.cols() && B.cols() == A.rows() && B.rows() == D.rows() &&
           D.rows() == D.cols());
    const SparseMatrix B_transposed = B.transpose();
    const auto first = static_cast<Index>(A.rows()), size = static_cast<Index>(first + D.rows());
    SparseMatrix result(size, size);
    result.reserve(A.nonZeros() + 2 * B.nonZeros() + D.nonZeros());
    for (Index row = 0; row < size; ++row) {
        const bool upper = row < first;
        const Index i = upper ? row : row - first;
        result.startVec(row);
        for (SparseMatrix::InnerIterator entry(upper ? A : B, i); entry; ++entry)
            result.insertBack(row, entry.col()) = entry.value();
        for (SparseMatrix::InnerIterator entry(upper ? B_transposed : D, i); entry; ++entry)
            result.insertBack(row, first + entry.col()) = entry.value();
    }
    result.finalize();
    return result;
}

SparseMatrix diagonal_matrix(const Vector& numbers) {
    SparseMatrix result(numbers.size(), numbers.size());
    result.setIdentity(); // Eigen cannot make an empty diagonal matrix
    result.coeffs() = numbers.array();
    return result;
}

} // namespace polydec
