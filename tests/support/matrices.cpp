// SPDX-License-Identifier: MIT
#include "tests/support/test.h"

namespace polydec::test {

double largest(const SparseMatrix& A) {
    double result = 0;
    for (Index i = 0; i < A.outerSize(); ++i)
        for (SparseMatrix::InnerIterator a(A, i); a; ++a)
            result = std::max(result, std::isnan(a.value()) ? INFINITY : std::abs(a.value()));
    return result;
}

double relative_difference(const SparseMatrix& A, const SparseMatrix& B) {
    if (A.rows() != B.rows() || A.cols() != B.cols())
        return INFINITY;
    const double scale = largest(B);
    return largest(A - B) / (scale > 0 ? scale : 1);
}

double relative_difference(const Vector& a, const Vector& b) {
    if (a.size() != b.size())
        return INFINITY;
    if (a.size() == 0)
        return 0;
    const double scale = b.cwiseAbs().maxCoeff(), difference = (a - b).cwiseAbs().maxCoeff();
    return std::isfinite(difference) ? difference / (scale > 0 ? scale : 1) : INFINITY;
}

IntegerMatrix integers(const IncidenceMatrix& D) {
    return D.cast<int>();
}

bool is_zero(const IntegerMatrix& A) {
    for (Index i = 0; i < A.outerSize(); ++i)
        for (IntegerMatrix::InnerIterator a(A, i); a; ++a)
            if (a.value() != 0)
                return false;
    return true;
}

bool equal(const IntegerMatrix& A, const IntegerMatrix& B) {
    return A.rows() == B.rows() && A.cols() == B.cols() && is_zero(A - B);
}

Vector random_vector(Index size, unsigned seed) {
    std::mt19937 random(seed);
    Vector result(size);
    for (double& x : result)
        x = 2.0 * random() / std::mt19937::max() - 1;
    return result;
}

SparseMatrix identity(Index size) {
    SparseMatrix I(size, size);
    I.setIdentity();
    return I;
}

SparseMatrix product(const SparseMatrix& A, const SparseMatrix& B) {
    return A * B;
}

SparseMatrix sparse(const DenseMatrix& A) {
    return A.sparseView();
}

} // namespace polydec::test
