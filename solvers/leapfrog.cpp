// SPDX-License-Identifier: MIT
#include "solvers/leapfrog.h"

#include "backends/registry.h"
#include "base/checks.h"
#include "base/errors.h"
#include "base/random.h"
#include "dec/advice.h"
#include "dec/forms/derivative.h"
#include "dec/forms/star.h"
#include "solvers/spectra/positive_mass.h"

#include <Eigen/Eigenvalues>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace polydec {

namespace {

void check_stars(const CellComplex& complex, const HodgeStars& stars, int k) {
    if (k < 0 || k >= complex.dimension())
        throw InvalidInput(fmt::format("waves of {}-forms are asked for: in dimension {} the "
                                       "degrees are 0 to {}",
                                       k, complex.dimension(), complex.dimension() - 1));
    check_fit(complex, stars);
    check_positive_mass(stars[k], Side::primal, k);
    const auto negative = stars[k + 1].negatives();
    if (!negative.empty())
        throw InvalidInput(fmt::format("the duals of {} {}-cells are negative, the first is cell "
                                       "{}: waves would grow without bound; take {}",
                                       negative.size(), k + 1,
                                       stars[k + 1].numbers({negative.front()}),
                                       positive_stars(stars.dimension())),
                           stars[k + 1].place(negative));
}

/// The largest eigenvalue of star_k^-1 d^T star_(k+1) d by Lanczos' iteration in the inner product
/// of star_k, which needs no root of it, with every basis vector made orthogonal to all before. To
/// the last Ritz value is added how far the nearest eigenvalue may be from it, so where the largest
/// ones crowd and the iteration ends early, it errs above.
/// Source: Parlett, The Symmetric Eigenvalue Problem, 1998, sec. 15.11.
double largest_eigenvalue(const SparseMatrix& d, const HodgeStar& star, const HodgeStar& upper) {
    constexpr Index most = 100;
    constexpr double tolerance = 1e-8, acceptable = 1e-2;
    const SparseMatrix d_transposed = d.transpose();
    const Index size = star.size(), last = std::min(most, size);
    DenseMatrix V(size, last), T = DenseMatrix::Zero(last, last);
    Vector next(size);
    Noise(1).fill(next);
    double norm = std::sqrt(next.dot(star * next));
    for (Index j = 0; j < last; ++j) {
        V.col(j) = next / norm;
        if (j > 0)
            T(j, j - 1) = T(j - 1, j) = norm;
        next = star.solve(d_transposed * (upper * Vector(d * V.col(j))));
        for (int pass = 0; pass < 2; ++pass) {
            const Vector products = V.leftCols(j + 1).transpose() * (star * next);
            next -= V.leftCols(j + 1) * products;
            T(j, j) += products[j];
        }
        norm = std::sqrt(std::max(0.0, next.dot(star * next)));

        // an invariant subspace, or all there is
        const bool is_whole = j + 1 == size || norm <= 1e-14 * T.cwiseAbs().maxCoeff();
        if (j % 8 != 7 && j + 1 < last && !is_whole)
            continue;
        const Eigen::SelfAdjointEigenSolver<DenseMatrix> ritz(T.topLeftCorner(j + 1, j + 1));
        const double value = ritz.eigenvalues()[j];
        const double residual = norm * std::abs(ritz.eigenvectors()(j, j));
        if (is_whole || residual <= (j + 1 < last ? tolerance : acceptable) * value)
            return value + residual;
    }
    throw SolverFailure("the largest frequency of the waves could not be found: Lanczos' "
                        "iteration did not converge");
}

} // namespace

double stable_step(const CellComplex& complex, const HodgeStars& stars, int k) {
    check_stars(complex, stars, k);
    const SparseMatrix d = derivative(complex, k);
    if (d.nonZeros() == 0)
        return std::numeric_limits<double>::infinity();
    if (!stars[k].is_diagonal() || !stars[k + 1].is_diagonal())
        return 2 / std::sqrt(largest_eigenvalue(d, stars[k], stars[k + 1]));
    const SparseMatrix d_transposed = d.transpose();
    const Vector root = stars[k].diagonal().cwiseSqrt().cwiseInverse();
    const Vector upper = stars[k + 1].diagonal();
    const SymmetricOperator A{complex.size(k), [&](const Vector& x, Vector& y) {
                                  const Vector curl = d * root.cwiseProduct(x);
                                  y = root.cwiseProduct(d_transposed * upper.cwiseProduct(curl));
                              }};
    const auto largest = make_eigen_solver("spectra")->largest(A, 1, {.tolerance = 1e-8});
    if (largest.converged < 1)
        throw SolverFailure("the largest frequency of the waves could not be found: the "
                            "eigensolver did not converge");
    return 2 / std::sqrt(largest.values[0]);
}

Leapfrog::Leapfrog(const CellComplex& complex, const HodgeStars& stars, int k, double time_step)
    : star_(stars[k]), upper_mass_(Operator::zero(0, 0)), time_step_(time_step) {
    const double limit = stable_step(complex, stars, k);
    if (!(time_step > 0 && time_step < limit))
        throw InvalidInput(fmt::format("a time step of {:.6g} is given: expected one above 0 and "
                                       "below {:.6g}, beyond which waves grow",
                                       time_step, limit));
    d_ = derivative(complex, k);
    d_transposed_ = d_.transpose();
    if (star_.is_diagonal())
        mass_ = star_.diagonal();
    upper_mass_ = Operator::star(stars[k + 1]);
}

void Leapfrog::check_sizes(const Vector& E, const Vector& B) const {
    check_as_many("values of E", E.size(), d_.cols());
    check_as_many("values of B", B.size(), d_.rows());
}

void Leapfrog::step(Vector& E, Vector& B) const {
    check_sizes(E, B);
    B -= time_step_ * (d_ * E);
    const Vector flow = d_transposed_ * (upper_mass_ * B);
    E += time_step_ * (star_.is_diagonal() ? Vector(flow.cwiseQuotient(mass_)) : star_.solve(flow));
}

double Leapfrog::energy(const Vector& E, const Vector& B) const {
    check_sizes(E, B);
    const Vector next = B - time_step_ * (d_ * E);
    return (E.dot(star_ * E) + B.dot(upper_mass_ * next)) / 2;
}

} // namespace polydec
