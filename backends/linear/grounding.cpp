// SPDX-License-Identifier: MIT
#include "backends/linear/grounding.h"

#include "base/decompositions.h"
#include "base/errors.h"
#include "base/row_sum_norm.h"

#include <fmt/format.h>

namespace polydec {

namespace {

constexpr double kernel_tolerance = 1e-8;

// Column-pivoted QR tells dependent columns from independent ones whatever their scale.
DenseMatrix orthonormal_kernel(const DenseMatrix& basis) {
    DenseMatrix scaled = basis;
    for (Eigen::Index j = 0; j < scaled.cols(); ++j) {
        const double size = scaled.col(j).stableNorm();
        if (size == 0.0)
            throw InvalidInput(fmt::format("kernel: column {} of the basis is zero", j));
        scaled.col(j) /= size;
    }
    Eigen::ColPivHouseholderQR<DenseMatrix> qr(scaled);
    qr.setThreshold(kernel_tolerance);
    if (qr.rank() < scaled.cols())
        throw InvalidInput(
            fmt::format("kernel: the {} columns of the basis span only {} dimensions\n"
                        "Give independent columns.",
                        scaled.cols(), qr.rank()));
    return qr.householderQ() * DenseMatrix::Identity(scaled.rows(), scaled.cols());
}

void check_basis(const SparseMatrix& A, const DenseMatrix& basis) {
    if (basis.rows() != A.rows() || basis.cols() > A.cols())
        throw InvalidInput(fmt::format("kernel: a basis of {} rows and {} columns cannot belong to "
                                       "a {} x {} matrix",
                                       basis.rows(), basis.cols(), A.rows(), A.cols()));
    if (!basis.allFinite())
        throw InvalidInput("kernel: the basis holds NaN or infinity");
}

void check_annihilated(const SparseMatrix& A, const DenseMatrix& basis) {
    const double scale = largest_entry(A);
    const DenseMatrix image = A * basis;
    for (Eigen::Index j = 0; j < basis.cols(); ++j) {
        const double limit = kernel_tolerance * scale * basis.col(j).cwiseAbs().maxCoeff();
        if (!(image.col(j).cwiseAbs().maxCoeff() <= limit))
            throw InvalidInput(fmt::format("kernel: the span holds a vector v with |A v| = {:.2g} "
                                           "|A|, so it is not the kernel",
                                           image.col(j).cwiseAbs().maxCoeff() / scale));
    }
}

} // namespace

Kernel::Kernel(const SparseMatrix& A, const DenseMatrix& basis) {
    check_basis(A, basis);
    basis_ = orthonormal_kernel(basis);
    check_annihilated(A, basis_);

    // The rows where the kernel is largest and most independent leave the best conditioned rest.
    const DenseMatrix transposed = basis_.transpose();
    const Eigen::ColPivHouseholderQR<DenseMatrix> qr(transposed);
    place_.assign(static_cast<std::size_t>(basis_.rows()), 0);
    for (Eigen::Index j = 0; j < basis_.cols(); ++j)
        place_[static_cast<std::size_t>(qr.colsPermutation().indices()[j])] = -1;

    for (std::size_t i = 0; i < place_.size(); ++i) {
        if (place_[i] < 0)
            continue;
        place_[i] = static_cast<Index>(kept_.size());
        kept_.push_back(static_cast<Index>(i));
    }
}

SparseMatrix Kernel::grounded(const SparseMatrix& A) const {
    const auto size = static_cast<Eigen::Index>(kept_.size());
    SparseMatrix result(size, size);
    result.reserve(A.nonZeros());
    for (const Index row : kept_) {
        const Index new_row = place_[static_cast<std::size_t>(row)];
        result.startVec(new_row);
        for (SparseMatrix::InnerIterator entry(A, row); entry; ++entry) {
            const Index new_column = place_[static_cast<std::size_t>(entry.col())];
            if (new_column >= 0)
                result.insertBack(new_row, new_column) = entry.value();
        }
    }
    result.finalize();
    return result;
}

DenseMatrix Kernel::restrict(const DenseMatrix& B) const {
    return B(kept_, Eigen::indexing::all);
}

DenseMatrix Kernel::extend(const DenseMatrix& X) const {
    DenseMatrix result = DenseMatrix::Zero(basis_.rows(), X.cols());
    result(kept_, Eigen::indexing::all) = X;
    return result;
}

DenseMatrix Kernel::project_out(const DenseMatrix& B) const {
    const DenseMatrix inside = basis_.transpose() * B;
    return B - basis_ * inside;
}

} // namespace polydec
