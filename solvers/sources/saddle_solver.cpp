// SPDX-License-Identifier: MIT
#include "solvers/sources/saddle_solver.h"

#include "backends/registry.h"
#include "base/block_matrix.h"
#include "base/checks.h"
#include "base/errors.h"
#include "base/row_sum_norm.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace polydec {

namespace {

/// The diagonal below M, for rows scaled so that D diag(M)^-1 D^T has diagonal 1. Pivots of this
/// size cost half of the digits, and refinement recovers them. It reduces the error in parts of c
/// by this number over their eigenvalue: the squared mesh frequency over the largest.
constexpr double below = 1e-8;

/// 1 over the roots of the diagonals of M and of D diag(M)^-1 D^T.
Vector scales_of(const SparseMatrix& M, const SparseMatrix& D) {
    check_as_many("columns of constraints", D.cols(), M.rows());
    Vector result(M.rows() + D.rows());
    for (Index i = 0; i < M.rows(); ++i)
        result[i] = 1 / std::sqrt(M.coeff(i, i));
    for (Index row = 0; row < D.rows(); ++row) {
        double sum = 0;
        for (SparseMatrix::InnerIterator entry(D, row); entry; ++entry)
            sum += std::pow(entry.value() * result[entry.col()], 2);
        result[M.rows() + row] = sum > 0 ? 1 / std::sqrt(sum) : 1;
    }
    return result;
}

/// The same for semidefinite M and C: from both equations for a single x, and for a single c. Empty
/// rows have the scale 1.
Vector scales_of(const SparseMatrix& M, const SparseMatrix& D, const SparseMatrix& C) {
    check_as_many("columns of constraints", D.cols(), M.rows());
    check_as_many("rows of constraints", D.rows(), C.rows());
    Vector x = M.diagonal(), c = C.diagonal();
    const auto entries = [&](auto add) {
        for (Index row = 0; row < D.rows(); ++row)
            for (SparseMatrix::InnerIterator entry(D, row); entry; ++entry)
                add(row, entry.col(), std::pow(entry.value(), 2));
    };
    const Vector of_C = c;
    entries([&](Index row, Eigen::Index column, double square) {
        if (of_C[row] > 0)
            x[column] += square / of_C[row];
    });
    entries([&](Index row, Eigen::Index column, double square) {
        if (!(of_C[row] > 0) && x[column] > 0)
            c[row] += square / x[column];
    });
    Vector result(x.size() + c.size());
    result << x, c;
    return result.unaryExpr([](double sum) { return sum == 0 ? 1 : 1 / std::sqrt(sum); });
}

/// The matrix with M above, D beside and below, -C; scaled, with these diagonals at M and below it.
SparseMatrix saddle(const SparseMatrix& M, const SparseMatrix& D, const SparseMatrix& C,
                    const Vector& scales, double of_M, double of_C) {
    const auto with_diagonal = [](const SparseMatrix& A, double factor, double number,
                                  const auto& part) -> SparseMatrix {
        if (number == 0)
            return factor * A;
        SparseMatrix diagonal(A.rows(), A.rows());
        diagonal.setIdentity();
        diagonal.coeffs() = number / part.array().square();
        return factor * A + diagonal;
    };
    SparseMatrix result = block_matrix(with_diagonal(M, 1, of_M, scales.head(M.rows())), D,
                                       with_diagonal(C, -1, of_C, scales.tail(D.rows())));
    for (Index i = 0; i < result.rows(); ++i)
        for (SparseMatrix::InnerIterator entry(result, i); entry; ++entry)
            entry.valueRef() *= scales[i] * scales[entry.col()];
    return result;
}

} // namespace

SaddleSolver::SaddleSolver(const SparseMatrix& M, const SparseMatrix& D, const std::string& engine,
                           int domain_dimension)
    : SaddleSolver(scales_of(M, D), M, D, SparseMatrix(D.rows(), D.rows()), 0, engine,
                   domain_dimension) {}

SaddleSolver::SaddleSolver(const SparseMatrix& M, const SparseMatrix& D, const SparseMatrix& C,
                           const std::string& engine, int domain_dimension)
    : SaddleSolver(scales_of(M, D, C), M, D, C, below, engine, domain_dimension) {}

SaddleSolver::SaddleSolver(Vector scales, const SparseMatrix& M, const SparseMatrix& D,
                           const SparseMatrix& C, double above, const std::string& engine,
                           int domain_dimension)
    : scales_(std::move(scales)),
      A_(saddle(M, D, C, scales_, 0, 0)),
      size_(static_cast<Index>(M.rows())),
      solver_(make_linear_solver(engine)) {
    if (!scales_.allFinite())
        throw InvalidInput("the diagonal of the matrix of inner products is not positive: expected "
                           "a positive definite matrix");
    solver_->factorize(saddle(M, D, C, scales_, above, -below),
                       {.symmetry = Symmetry::symmetric,
                        .domain_dimension = domain_dimension,
                        .many_solves = true});
    // on the kernel of D, M determines the signs
    if (const auto negative = solver_->negative_pivots(); negative && *negative != D.rows())
        throw InvalidInput(fmt::format("the matrix of inner products has {} negative eigenvalues: "
                                       "expected a positive definite matrix",
                                       *negative - D.rows()));
}

/// The combination of steps of refinement, of which this is the first, that leaves the smallest
/// step, down to `enough`. Unlike steps alone it finds parts of eigenvalues far below `below`, and
/// nothing of the kernel.
Vector SaddleSolver::accelerated(Vector step, double enough) const {
    constexpr int most = 100;
    constexpr double kernel = 1e-7;
    std::vector<Vector> parts, changes; // changes are orthonormal
    Vector result = Vector::Zero(step.size());
    for (int j = 0; j < most && step.norm() > enough; ++j) {
        Vector part = step, change = solver_->solve(A_ * step);
        for (int pass = 0; pass < 2; ++pass)
            for (int i = 0; i < j; ++i) {
                const double along = changes[i].dot(change);
                change -= along * changes[i];
                part -= along * parts[i];
            }
        const double size = change.norm();
        if (!(size > kernel * part.norm()))
            break;
        parts.emplace_back(part / size);
        changes.emplace_back(change / size);
        const double length = changes[j].dot(step);
        result += length * parts[j];
        step -= length * changes[j];
    }
    return result;
}

SaddleSolver::Values SaddleSolver::solve(const Vector& f, const Vector& g,
                                         const Vector& terms) const {
    check_as_many("values of the upper right-hand side", f.size(), size_);
    check_as_many("values of the lower right-hand side", g.size(), A_.rows() - size_);
    Vector b(A_.rows());
    b << f, g;
    b = b.cwiseProduct(scales_);
    double size_of_data = b.lpNorm<Eigen::Infinity>();
    if (terms.size() > 0) {
        check_as_many("terms of the right-hand side", terms.size(), b.size());
        size_of_data =
            std::max(size_of_data, terms.cwiseProduct(scales_).lpNorm<Eigen::Infinity>());
    }
    const auto size_of = [](const Vector& x) { return x.lpNorm<Eigen::Infinity>(); };
    Vector y = Vector::Zero(b.size()), left = b;
    // corrections shrink to rounding level, at the latest that of the residual
    constexpr int most = 100;
    constexpr double rounding = 4 * std::numeric_limits<double>::epsilon(), fine = 1e-8;
    bool is_slow = false; // parts of eigenvalues below `below`, or of the kernel
    double last = std::numeric_limits<double>::infinity();
    for (int pass = 0; pass < most && !left.isZero(0); ++pass) {
        Vector step = solver_->solve(left);
        if (!is_slow && !(size_of(step) < last / 2)) {
            is_slow = true;
            last = std::numeric_limits<double>::infinity();
        }
        if (is_slow)
            step = accelerated(std::move(step), 1e-12 * y.norm());
        if (!(size_of(step) < last / 2))
            break;
        y += step;
        left = b - A_ * y;
        last = size_of(step);
        if (last <= (is_slow ? fine : rounding) * size_of(y))
            break;
    }
    const double scale = row_sum_norm(A_) * y.lpNorm<Eigen::Infinity>() + size_of_data;
    const double error = scale > 0 ? left.lpNorm<Eigen::Infinity>() / scale : 0;
    SolveReport report = solver_->report();
    report.backward_error = error;
    report.residual = b.isZero(0) ? 0 : left.stableNorm() / b.stableNorm();
    constexpr double limit = 1e-10, longest = 1e-7;
    if (!(error <= limit) || (is_slow && last > longest * size_of(y)))
        throw SolverFailure(
            fmt::format("{}: the solution of a mixed problem is unreliable: backward error {:.2g}\n"
                        "The matrix of inner products is nearly singular, or the data contradict "
                        "each other.",
                        report.engine, error),
            report);
    const Vector solution = y.cwiseProduct(scales_);
    return {solution.head(size_), solution.tail(g.size()), report};
}

} // namespace polydec
