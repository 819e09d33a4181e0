// SPDX-License-Identifier: MIT
#include "backends/eigen/orthonormal_basis.h"

#include "backends/blas.h"
#include "base/decompositions.h"
#include "base/errors.h"

#include <fmt/format.h>

#include <algorithm>

namespace polydec {

namespace {

// A unit vector that keeps this much in a projection is orthogonal to rounding behind it: "twice is
// enough" (Giraud, Langou, Rozloznik and van den Eshof 2005).
constexpr double kept_enough = 0.5;

// Of a unit vector that loses this much in a projection only rounding is left.
constexpr double only_rounding = 1e-13;

// Noise in a space that is nearly used up loses digits in every pass.
constexpr int most_passes = 8;

// The square of the condition below which the Gram matrix of unit vectors is safe to factorize; the
// pass that follows takes away the loss of orthogonality.
constexpr double safe_pivot = 1e-8;

// Rows taken together where a product replaces its own factor.
constexpr Eigen::Index chunk = 2048;

} // namespace

OrthonormalBasis::OrthonormalBasis(Eigen::Index rows, Eigen::Index capacity)
    : columns_(rows, capacity) {
    if (capacity > rows)
        throw InvalidInput(fmt::format("{} orthonormal columns of {} entries: expected at most {}",
                                       capacity, rows, rows));
}

DenseMatrix OrthonormalBasis::append(DenseMatrix& W, double floor) {
    if (W.rows() != columns_.rows() || size_ + W.cols() > columns_.cols())
        throw InvalidInput(fmt::format("{} columns of {} entries do not fit into a basis of {} "
                                       "columns with room for {} of {} entries",
                                       W.cols(), W.rows(), size_, columns_.cols(),
                                       columns_.rows()));
    const auto basis = columns_.leftCols(size_);
    DenseMatrix R = orthonormalize(W, floor);
    for (int pass = 0; pass < most_passes; ++pass) {
        const DenseMatrix part = transposed_product(basis, W);
        add_product(-1, basis, part, 1, W);
        const DenseMatrix left = orthonormalize(W, only_rounding);
        R = left * R;
        if (left.diagonal().size() == 0 || left.diagonal().minCoeff() > kept_enough)
            break;
    }
    columns_.middleCols(size_, W.cols()) = W;
    size_ += W.cols();
    return R;
}

void OrthonormalBasis::combine(const DenseMatrix& S) {
    const Eigen::Index behind = size_ - S.rows();
    for (Eigen::Index first = 0; first < columns_.rows(); first += chunk) {
        auto rows = columns_.middleRows(first, std::min(chunk, columns_.rows() - first));
        scratch_.resize(rows.rows(), S.cols());
        add_product(1, rows.leftCols(S.rows()), S, 0, scratch_);
        rows.leftCols(S.cols()) = scratch_;
    }
    for (Eigen::Index j = 0; j < behind; ++j)
        columns_.col(S.cols() + j) = columns_.col(S.rows() + j);
    size_ = S.cols() + behind;
}

// W becomes Q with W = Q R, by the Cholesky factor of its Gram matrix where that is safe.
DenseMatrix OrthonormalBasis::orthonormalize(DenseMatrix& W, double floor) {
    const DenseMatrix gram = transposed_product(W, W);
    if (!gram.allFinite())
        throw SolverFailure("orthonormal columns: an entry is NaN or infinite");
    const Vector lengths = gram.diagonal().cwiseSqrt();
    if (!(lengths.array() > floor).all())
        return orthonormalize_one_by_one(W, floor);
    const Vector inverse = lengths.cwiseInverse();
    const Eigen::LLT<DenseMatrix> factor(inverse.asDiagonal() * gram * inverse.asDiagonal());
    const DenseMatrix L = factor.matrixL();
    if (factor.info() != Eigen::Success || !(L.diagonal().array().square() > safe_pivot).all())
        return orthonormalize_one_by_one(W, floor);

    const DenseMatrix R = L.transpose() * lengths.asDiagonal();
    const DenseMatrix unit = DenseMatrix::Identity(W.cols(), W.cols());
    const DenseMatrix R_inverse = R.triangularView<Eigen::Upper>().solve(unit);
    scratch_.resize(W.rows(), W.cols());
    add_product(1, W, R_inverse, 0, scratch_);
    W.swap(scratch_);
    return R;
}

// The same by Gram and Schmidt, twice; zero columns are filled when all others are there.
DenseMatrix OrthonormalBasis::orthonormalize_one_by_one(DenseMatrix& W, double floor) {
    const Eigen::Index width = W.cols();
    DenseMatrix R = DenseMatrix::Zero(width, width);
    for (Eigen::Index j = 0; j < width; ++j) {
        const double length = W.col(j).stableNorm();
        for (int pass = 0; pass < 2; ++pass) {
            const Vector part = W.leftCols(j).transpose() * W.col(j);
            W.col(j).noalias() -= W.leftCols(j) * part;
            R.col(j).head(j) += part;
        }
        const double left = W.col(j).stableNorm();
        if (left > std::max(floor, only_rounding * length)) {
            W.col(j) /= left;
            R(j, j) = left;
        } else {
            W.col(j).setZero();
        }
    }
    for (Eigen::Index j = 0; j < width; ++j)
        if (R(j, j) == 0.0)
            fill_with_noise(W, j);
    return R;
}

// A unit column orthogonal to the others, of which those that are zero do not matter.
void OrthonormalBasis::fill_with_noise(DenseMatrix& W, Eigen::Index j) {
    noise_.fill(W.col(j));
    W.col(j).normalize();
    for (int pass = 0; pass < 2; ++pass) {
        Vector part = W.transpose() * W.col(j);
        part[j] = 0.0;
        W.col(j) -= W * part;
        W.col(j).normalize();
    }
}

} // namespace polydec
