// SPDX-License-Identifier: MIT
#include "backends/spectra/mass.h"

#include "backends/linear/counting_factor.h"
#include "base/block_matrix.h"
#include "base/errors.h"

#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace polydec {

namespace {

class DiagonalMass final : public Mass {
public:
    explicit DiagonalMass(const Vector& diagonal)
        : Mass(diagonal, 1), root_(diagonal.cwiseSqrt()) {}

    bool is_diagonal() const override { return true; }

    SparseMatrix matrix() const override { return diagonal_matrix(diagonal_); }

    LongVector times(const LongVector& x, Vector& error) const override {
        LongVector result = diagonal_.cast<long double>().cwiseProduct(x);
        error = unit_roundoff() * result.cwiseAbs().cast<double>();
        return result;
    }

    Vector spread(const Vector& sizes) const override { return diagonal_.cwiseProduct(sizes); }

    LongVector solve(const LongVector& z, Vector& error) const override {
        error = unit_roundoff() * z.cwiseAbs().cast<double>();
        return z.cwiseQuotient(diagonal_.cast<long double>());
    }

    DenseMatrix root(const DenseMatrix& X) const override { return root_.asDiagonal() * X; }
    DenseMatrix unroot(const DenseMatrix& X) const override {
        return root_.cwiseInverse().asDiagonal() * X;
    }
    DenseMatrix transposed_root(const DenseMatrix& X) const override { return root(X); }
    DenseMatrix transposed_unroot(const DenseMatrix& X) const override { return unroot(X); }

    long double inverse_square(const LongVector& x) const override {
        long double sum = 0;
        for (Index i = 0; i < size(); ++i)
            sum += x[i] * x[i] / diagonal_[i];
        return sum;
    }

private:
    Vector root_;
};

using ColumnMatrix = Eigen::SparseMatrix<double, Eigen::ColMajor, Index>;

/// By a sparse factor P M P^T = L L^T with fill-reducing order P, so R = L^T P.
class MatrixMass final : public Mass {
public:
    explicit MatrixMass(const SparseMatrix& matrix)
        : Mass(matrix.diagonal(), 0), matrix_(matrix), absolute_(matrix.cwiseAbs()) {
        factorize();
        dominance_ = least_eigenvalue();
    }

    bool is_diagonal() const override { return false; }
    SparseMatrix matrix() const override { return matrix_; }

    LongVector times(const LongVector& x, Vector& error) const override {
        error = longest_row_ * unit_roundoff() * spread(x.cwiseAbs().cast<double>());
        return times(x);
    }

    Vector spread(const Vector& sizes) const override { return absolute_ * sizes; }

    LongVector solve(const LongVector& z, Vector& error) const override {
        LongVector x = LongVector::Zero(size()), rest = z;
        for (int step = 0; step < refinements; ++step) {
            x += inverse_times(rest.cast<double>()).cast<long double>();
            rest = z - times(x);
        }
        const Vector sizes =
            spread(x.cwiseAbs().cast<double>()) + Vector(z.cwiseAbs().cast<double>());
        error = rest.cwiseAbs().cast<double>() + longest_row_ * unit_roundoff() * sizes;
        return x;
    }

    DenseMatrix root(const DenseMatrix& X) const override {
        return factor_.matrixU() * DenseMatrix(factor_.permutationP() * X);
    }
    DenseMatrix unroot(const DenseMatrix& X) const override {
        return factor_.permutationPinv() * DenseMatrix(factor_.matrixU().solve(X));
    }
    DenseMatrix transposed_root(const DenseMatrix& X) const override {
        return factor_.permutationPinv() * DenseMatrix(factor_.matrixL() * X);
    }
    DenseMatrix transposed_unroot(const DenseMatrix& X) const override {
        return factor_.matrixL().solve(DenseMatrix(factor_.permutationP() * X));
    }

    long double inverse_square(const LongVector& x) const override {
        return transposed_unroot(x.cast<double>()).cast<long double>().squaredNorm();
    }

private:
    void factorize() {
        const ColumnMatrix columns = matrix_;
        factor_.analyzePattern(columns);
        if (!factor_.fits())
            throw SolverFailure(fmt::format("the root of a {} x {} matrix has more than 2^31 - 1 "
                                            "entries: use a diagonal star, or a smaller mesh",
                                            columns.rows(), columns.cols()));
        factor_.factorize(columns);
        if (factor_.info() != Eigen::Success)
            throw InvalidInput("a matrix of inner products is not positive definite");
    }

    Vector inverse_times(const Vector& b) const { return factor_.solve(b); }

    LongVector times(const LongVector& x) const {
        LongVector result(size());
        for (Index i = 0; i < size(); ++i) {
            long double sum = 0;
            for (SparseMatrix::InnerIterator entry(matrix_, i); entry; ++entry)
                sum += entry.value() * x[entry.col()];
            result[i] = sum;
        }
        return result;
    }

    /// Of diag(M)^-1/2 M diag(M)^-1/2: inverse iteration comes to it from above.
    double least_eigenvalue() const {
        constexpr int steps = 8;
        constexpr double room = 0.25;
        const Vector scale = diagonal_.cwiseSqrt();
        Vector probe = Vector::NullaryExpr(size(), [](Index i) { return std::sin(1.0 + i); });
        for (int step = 0; step < steps; ++step) {
            probe.normalize();
            probe = scale.cwiseProduct(inverse_times(scale.cwiseProduct(probe)));
        }
        return std::min(1.0, room / probe.norm());
    }

    static constexpr int refinements = 3;

    SparseMatrix matrix_, absolute_;
    CountingFactor<Eigen::SimplicialLLT<ColumnMatrix, Eigen::Lower, Eigen::AMDOrdering<Index>>>
        factor_;
    double longest_row_ = static_cast<double>(longest_row(matrix_) + 1);
};

} // namespace

double unit_roundoff() {
    return static_cast<double>(std::numeric_limits<long double>::epsilon());
}

Index longest_row(const SparseMatrix& A) {
    Index longest = 0;
    for (Index i = 0; i < A.rows(); ++i)
        longest = std::max(longest, A.outerIndexPtr()[i + 1] - A.outerIndexPtr()[i]);
    return longest;
}

long double Mass::inverse_square_bound(const Vector& sizes) const {
    long double sum = 0;
    for (Index i = 0; i < size(); ++i)
        sum += static_cast<long double>(sizes[i]) * sizes[i] / diagonal_[i];
    return sum / dominance_;
}

SparseMatrix symmetric_part(const SparseMatrix& B) {
    return (B + SparseMatrix(B.transpose())) / 2;
}

Vector diagonal(const Weights& weights) {
    const auto* W = std::get_if<SparseMatrix>(&weights);
    return W ? Vector(W->diagonal()) : std::get<Vector>(weights);
}

Weights congruent(const Weights& weights, const Vector& D) {
    if (const auto* W = std::get_if<SparseMatrix>(&weights))
        return SparseMatrix(D.asDiagonal() * *W * D.asDiagonal());
    return Vector(std::get<Vector>(weights).cwiseProduct(D).cwiseProduct(D));
}

std::unique_ptr<const Mass> make_mass(const Weights& weights) {
    if (const auto* numbers = std::get_if<Vector>(&weights))
        return std::make_unique<DiagonalMass>(*numbers);
    return std::make_unique<MatrixMass>(symmetric_part(std::get<SparseMatrix>(weights)));
}

} // namespace polydec
