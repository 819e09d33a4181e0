// SPDX-License-Identifier: MIT
#include "solvers/leapfrog.h"

#include "backends/registry.h"
#include "base/checks.h"
#include "base/errors.h"
#include "dec/advice.h"
#include "dec/forms/derivative.h"
#include "dec/forms/star.h"
#include "solvers/spectra/positive_mass.h"

#include <fmt/format.h>

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
                                       nearer_to_delaunay(stars.dimension())),
                           stars[k + 1].place(negative));
}

} // namespace

double stable_step(const CellComplex& complex, const HodgeStars& stars, int k) {
    check_stars(complex, stars, k);
    const SparseMatrix d = derivative(complex, k);
    const SparseMatrix d_transposed = d.transpose();
    const Vector root = stars[k].diagonal().cwiseSqrt().cwiseInverse();
    const Vector upper = stars[k + 1].diagonal();
    if (d.nonZeros() == 0)
        return std::numeric_limits<double>::infinity();
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
    : time_step_(time_step) {
    const double limit = stable_step(complex, stars, k);
    if (!(time_step > 0 && time_step < limit))
        throw InvalidInput(fmt::format("a time step of {:.6g} is given: expected one above 0 and "
                                       "below {:.6g}, beyond which waves grow",
                                       time_step, limit));
    d_ = derivative(complex, k);
    d_transposed_ = d_.transpose();
    mass_ = stars[k].diagonal();
    upper_mass_ = stars[k + 1].diagonal();
}

void Leapfrog::check_sizes(const Vector& E, const Vector& B) const {
    check_as_many("values of E", E.size(), d_.cols());
    check_as_many("values of B", B.size(), d_.rows());
}

void Leapfrog::step(Vector& E, Vector& B) const {
    check_sizes(E, B);
    B -= time_step_ * (d_ * E);
    const Vector flow = d_transposed_ * upper_mass_.cwiseProduct(B);
    E += time_step_ * flow.cwiseQuotient(mass_);
}

double Leapfrog::energy(const Vector& E, const Vector& B) const {
    check_sizes(E, B);
    const Vector next = B - time_step_ * (d_ * E);
    return (E.dot(mass_.cwiseProduct(E)) + B.dot(upper_mass_.cwiseProduct(next))) / 2;
}

} // namespace polydec
