// SPDX-License-Identifier: MIT
#include "solvers/leapfrog.h"

#include "backends/registry.h"
#include "base/checks.h"
#include "base/errors.h"
#include "dec/advice.h"
#include "dec/forms/star.h"
#include "solvers/spectra/laplacian_pencil.h"
#include "solvers/spectra/mass.h"
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
                                       positive_stars(stars.dimension())),
                           stars[k + 1].place(negative));
}

double checked_step(const CellComplex& complex, const HodgeStars& stars, int k, double time_step) {
    const double limit = stable_step(complex, stars, k);
    if (!(time_step > 0 && time_step < limit))
        throw InvalidInput(fmt::format("a time step of {:.6g} is given: expected one above 0 and "
                                       "below {:.6g}, beyond which waves grow",
                                       time_step, limit));
    return time_step;
}

} // namespace

double stable_step(const CellComplex& complex, const HodgeStars& stars, int k) {
    check_stars(complex, stars, k);
    const Operator d = Operator::derivative(complex, k);
    if (complex.incidences(k).size() == 0)
        return std::numeric_limits<double>::infinity();
    // in the scale in which the mass is 1: R^-T d^T star_(k+1) d R^-1, star_k = R^T R
    const auto mass = make_mass(weights(stars[k]));
    const Operator stiffness = d.transposed() * Operator::star(stars[k + 1]) * d;
    const SymmetricOperator A{mass->size(), [&](const Vector& x, Vector& y) {
                                  const Vector flow = stiffness * Vector(mass->unroot(x));
                                  y = mass->transposed_unroot(flow.cast<long double>());
                              }};
    const auto largest = make_eigen_solver("spectra")->largest(A, 1, {.tolerance = 1e-8});
    if (largest.converged < 1)
        throw SolverFailure("the largest frequency of the waves could not be found: the "
                            "eigensolver did not converge");
    return 2 / std::sqrt(largest.values[0]);
}

Leapfrog::Leapfrog(const CellComplex& complex, const HodgeStars& stars, int k, double time_step)
    : time_step_(checked_step(complex, stars, k, time_step)),
      d_(Operator::derivative(complex, k)),
      mass_(Operator::star(stars[k])),
      upper_mass_(Operator::star(stars[k + 1])),
      acceleration_(Operator::inverse_star(stars[k]) * d_.transposed() * upper_mass_) {}

void Leapfrog::check_sizes(const Vector& E, const Vector& B) const {
    check_as_many("values of E", E.size(), d_.cols());
    check_as_many("values of B", B.size(), d_.rows());
}

void Leapfrog::step(Vector& E, Vector& B) const {
    check_sizes(E, B);
    B -= time_step_ * (d_ * E);
    E += time_step_ * (acceleration_ * B);
}

double Leapfrog::energy(const Vector& E, const Vector& B) const {
    check_sizes(E, B);
    const Vector next = B - time_step_ * (d_ * E);
    return (E.dot(mass_ * E) + B.dot(upper_mass_ * next)) / 2;
}

} // namespace polydec
