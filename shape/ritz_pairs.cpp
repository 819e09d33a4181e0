// SPDX-License-Identifier: MIT
#include "shape/ritz_pairs.h"

#include "backends/blas.h"
#include "backends/registry.h"
#include "backends/spectra/inertia.h"
#include "backends/spectra/mass.h"
#include "backends/spectra/scaled_part.h"
#include "base/errors.h"
#include "base/random.h"
#include "base/row_sum_norm.h"
#include "system/memory.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace polydec {

namespace {

constexpr const char* engine = "Rayleigh-Ritz";

/// Values of these conforming functions from values of linear ones.
DenseMatrix interpolated(const ConformingForm& linear, const DenseMatrix& values,
                         const ConformingForm& to) {
    const auto& [_, corners, corner_signs] = linear.points();
    const auto& [size, points, signs] = to.points();
    const std::size_t width = to.pairs().size();
    DenseMatrix result = DenseMatrix::Zero(size, values.cols());
    for (std::size_t point = 0; point < points.size(); ++point) {
        if (points[point] < 0)
            continue;
        result.row(points[point]).setZero();
        for (const int corner : to.pairs()[point % width]) {
            const std::size_t at = linear.pairs().size() * (point / width) + corner;
            if (corners[at] >= 0)
                result.row(points[point]) +=
                    0.5 * signs[point] * corner_signs[at] * values.row(corners[at]);
        }
    }
    return result;
}

/// The space that grows with each block (K + shift M)^-1 M X, X the block before. Its basis is
/// orthonormal in M.
class KrylovSpace {
public:
    KrylovSpace(const SparseMatrix& K, const SparseMatrix& M) : K_(K), M_(M), basis_(K.rows(), 0) {}

    /// What solves with K + shift M.
    void grow(LinearSolver& solver) { add(solver.solve(DenseMatrix(M_ * block()))); }

    /// Adds the span of these columns.
    void add(DenseMatrix X) {
        const Vector norms = X.cwiseProduct(M_ * X).colwise().sum().cwiseSqrt();
        X *= norms.cwiseInverse().asDiagonal();
        for (int pass = 0; pass < 2 && X.cols() > 0; ++pass) {
            add_product(-1, basis_, transposed_product(basis_, M_ * X), 1, X);
            X = orthonormal(X);
        }
        added_ = X.cols();
        const Eigen::Index all = basis_.cols() + added_;
        basis_.conservativeResize(Eigen::NoChange, all);
        basis_.rightCols(added_) = X;
        projected_.conservativeResize(all, all);
        projected_.bottomRows(added_) = transposed_product(K_ * X, basis_);
    }

    bool is_complete() const { return added_ == 0 || basis_.cols() == basis_.rows(); }

    SymmetricPairs pairs() const { return symmetric_pairs(projected_, engine); }
    DenseMatrix vectors(const DenseMatrix& combinations) const { return basis_ * combinations; }

private:
    Eigen::Ref<const DenseMatrix> block() const { return basis_.rightCols(added_); }

    /// Without directions that are in the space but for rounding.
    DenseMatrix orthonormal(const DenseMatrix& X) const {
        const auto [values, vectors] = symmetric_pairs(transposed_product(X, M_ * X), engine);
        constexpr double rounding = 1e-9;
        const double least = rounding * std::max(rounding, 1e-4 * values.tail(1).sum());
        const Eigen::Index kept = (values.array() > least).count();
        const Vector scale = values.tail(kept).cwiseSqrt().cwiseInverse();
        return X * DenseMatrix(vectors.rightCols(kept) * scale.asDiagonal());
    }

    const SparseMatrix &K_, &M_;
    DenseMatrix basis_, projected_; // of this, the lower triangle
    Eigen::Index added_ = 0;
};

/// D A D 2^exponent, D the powers of two `units`: without rounding.
CountedMatrix scaled(const CountedMatrix& A, const Vector& units, int exponent) {
    auto matrix =
        std::make_shared<SparseMatrix>(units.asDiagonal() * *A.matrix * units.asDiagonal());
    scale_entries(*matrix, exponent);
    CountedMatrix result{matrix, A.doubt};
    result.doubt.sizes = std::ldexp(1.0, exponent) * A.doubt.sizes.cwiseProduct(units.cwiseAbs2());
    return result;
}

/// V = X^T A X, and bounds E: for all c, c^T V c is off by at most |c|^T E |c|, by the errors of A,
/// of A X and of the product.
struct Products {
    DenseMatrix values, errors;
};

Products products(const CountedMatrix& A, const DenseMatrix& X) {
    constexpr double unit = std::numeric_limits<double>::epsilon() / 2;
    const DenseMatrix image = *A.matrix * X, sizes = X.cwiseAbs();
    // |A| compared with the sizes
    const Vector scale = A.doubt.sizes.cwiseSqrt().cwiseInverse();
    const double ratio = scale.cwiseProduct(A.matrix->cwiseAbs() * scale).maxCoeff();
    const double share = A.doubt.share + (longest_row(*A.matrix) + 1) * unit * ratio;
    return {transposed_product(X, image),
            transposed_product(sizes, share * A.doubt.sizes.asDiagonal() * sizes +
                                          X.rows() * unit * image.cwiseAbs())};
}

} // namespace

Vector rayleigh_ritz_bounds(const CountedMatrix& K, const CountedMatrix& M, const DenseMatrix& X) {
    const auto [energies, energy_errors] = products(K, X);
    const auto [masses, mass_errors] = products(M, X);
    const DenseMatrix coupling = energies - DenseMatrix(energies.diagonal().asDiagonal()),
                      defect = masses - DenseMatrix::Identity(X.cols(), X.cols());
    Vector result(X.cols());
    double highest = 0;
    for (Eigen::Index j = 0; j < X.cols(); ++j) {
        const auto norm = [&](const DenseMatrix& A) {
            return A.topLeftCorner(j + 1, j + 1).norm();
        };
        highest = std::max(highest, energies(j, j));
        const double mass = 1 - norm(defect) - norm(mass_errors);
        result[j] = mass > 0 ? (1 + 1e-12) * (highest + norm(coupling) + norm(energy_errors)) / mass
                             : std::numeric_limits<double>::infinity();
    }
    return result;
}

Index largest_gap(const Vector& values, Index first) {
    auto result = static_cast<Index>(values.size());
    double gap = 0;
    for (Index j = first; j < values.size(); ++j)
        if (values[j] - values[j - 1] > gap) {
            gap = values[j] - values[j - 1];
            result = j;
        }
    return result;
}

RitzSolver::RitzSolver(const Shape& shape, const ConformingForm& form, Index zeros,
                       const ShapeSpectrumOptions& options)
    : form_(form),
      linear_(shape, 1),
      zeros_(zeros),
      options_(options),
      K_(form.stiffness()),
      M_(form.mass()),
      units_(powers_of_two(M_.matrix->diagonal(), -1)) {
    K_ = scaled(K_, units_, 0);
    M_ = scaled(M_, units_, 0);
    exponent_ = std::ilogb(largest_entry(*K_.matrix));
    K_ = scaled(K_, Vector::Ones(units_.size()), -exponent_);
    shift_ = K_.matrix->diagonal().mean() / M_.matrix->diagonal().mean();
    facts_.symmetry = Symmetry::symmetric;
    facts_.definiteness = Definiteness::positive;
    facts_.domain_dimension = shape.pieces.dimension();
    facts_.many_solves = true;
    if (linear_.family().size() == 0)
        return;
    const CountedMatrix K = linear_.stiffness(), M = linear_.mass();
    const Vector lumped = M.matrix->cwiseAbs() * Vector::Ones(M.matrix->cols());
    start_.emplace(*K.matrix, lumped,
                   EigensolverOptions{.linear_solver = options.linear_solver,
                                      .eigen_solver = options.eigen_solver,
                                      .domain_dimension = facts_.domain_dimension,
                                      .definiteness = Definiteness::semidefinite,
                                      .zeros = zeros,
                                      .progress = options.progress});
}

/// As many vectors as reach a gap behind the first `count` that is not much smaller than usual.
DenseMatrix RitzSolver::start(Index count) {
    const Index more = std::max<Index>(3, count / 10), most = linear_.family().size();
    Index wanted = count + more, known = 0;
    CertifiedEigenpairs pairs;
    while (known < std::min(wanted, most)) {
        try {
            pairs = start_->smallest(std::min(wanted, most));
        } catch (const OutOfMemory&) {
            throw;
        } catch (const SolverFailure&) { // then others start at random
            break;
        }
        known = std::min(wanted, most);
        const Vector& values = pairs.values;
        const Index gap = largest_gap(values, count);
        const double usual = values[known - 1] / known;
        if (wanted < 2 * count && (gap >= known || values[gap] - values[gap - 1] < usual / 4))
            wanted += more;
    }
    DenseMatrix X(form_.family().size(), std::min(wanted, form_.family().size()));
    Noise(3).fill(X.reshaped());
    if (known > 0)
        X.leftCols(known) =
            units_.cwiseInverse().asDiagonal() * interpolated(linear_, pairs.vectors, form_);
    constexpr double rounding = 1e-13; // of K, beside which a smaller shift would vanish
    if (zeros_ < known)
        shift_ = std::max(std::ldexp(pairs.values[zeros_], -exponent_), rounding);
    return X;
}

RitzPairs RitzSolver::smallest(Index count) {
    constexpr int most_steps = 20;
    constexpr double fine = 1e-6; // a step that changes values so little leaves far less to do
    const DenseMatrix X = start(count);
    KrylovSpace space(*K_.matrix, *M_.matrix);
    space.add(X);
    if (!solver_) {
        solver_ = make_linear_solver(options_.linear_solver);
        if (shift_ < 1e-8) // so far below K, residuals of solves are not small beside it
            facts_.inertia = Inertia::wanted;
        solver_->factorize(SparseMatrix(*K_.matrix + shift_ * *M_.matrix), facts_);
    }
    SymmetricPairs pairs = space.pairs();
    for (int step = 0; step < most_steps && !space.is_complete(); ++step) {
        if (options_.progress)
            options_.progress("a step of the iteration");
        space.grow(*solver_);
        const Vector before = std::exchange(pairs, space.pairs()).values.head(count),
                     after = pairs.values.head(count);
        if (((before - after).array() <= fine * after.array()).tail(count - zeros_).all())
            break;
    }
    if (form_.family().size() > most_beside_another)
        solver_.reset();
    const DenseMatrix Y = space.vectors(pairs.vectors.leftCols(X.cols()));
    Vector upper = std::ldexp(1.0, exponent_) * rayleigh_ritz_bounds(K_, M_, Y);
    upper.head(zeros_).setZero();
    return {units_.asDiagonal() * Y, upper};
}

} // namespace polydec
