// SPDX-License-Identifier: MIT
#include "solvers/diffusion.h"

#include "backends/registry.h"
#include "base/block_matrix.h"
#include "base/errors.h"
#include "dec/forms/laplacian.h"
#include "solvers/spectra/positive_mass.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace polydec {

namespace {

/// M_k + t (d^T M_(k+1) d + weights, if there are), and beside it t times d^T M_k and, negative,
/// M_(k-1): of a form and its codifferential. Quasi-definite, so that it has factors in every
/// order.
SparseMatrix mixed_step(const CellComplex& complex, const HodgeStars& stars, const Vector& weights,
                        int k, double t) {
    const Operator mass = Operator::star(stars[k]);
    const Operator below = Operator::derivative(complex, k - 1).transposed();
    Operator A = weights.size() > 0 ? mass + t * Operator::weights(weights) : mass;
    if (k < complex.dimension()) {
        const Operator d = Operator::derivative(complex, k);
        A = A + t * (d.transposed() * Operator::star(stars[k + 1]) * d);
    }
    return block_matrix(A, t * (below * mass), -t * Operator::star(stars[k - 1]));
}

RobinComplex conditioned(const CellComplex& complex, const HodgeStars& stars, Side side, int degree,
                         const DiffusionOptions& options) {
    if (options.conditions)
        return with_robin(complex, stars, side, degree, *options.conditions);
    return {{relative_complex(complex, essential_cells(complex, built_in_conditions(Side::primal))),
             stars},
            {}};
}

void check_size(const Vector& values, Index size) {
    if (values.size() != size)
        throw InvalidInput(fmt::format("{} boundary values are given: expected {}, one for each "
                                       "cell of their degree",
                                       values.size(), size));
}

} // namespace

Diffusion::Diffusion(const Discretization& mesh, Side side, int degree,
                     const DiffusionOptions& options)
    : Diffusion(
          mesh.complex(), mesh.stars(),
          with_robin(mesh, side, degree, options.conditions.value_or(built_in_conditions(side))),
          side, degree, options) {}

Diffusion::Diffusion(const CellComplex& complex, const HodgeStars& stars, Side side, int degree,
                     const DiffusionOptions& options)
    : Diffusion(complex, stars, conditioned(complex, stars, side, degree, options), side, degree,
                options) {}

Diffusion::Diffusion(const CellComplex& whole, const HodgeStars& all_stars, RobinComplex given,
                     Side side, int degree, const DiffusionOptions& options)
    : side_(side),
      degree_(degree),
      coefficient_(options.coefficient),
      stiffness_(Operator::zero(0, 0)),
      mass_(given.space.stars[cell_degree(whole, side, degree)]),
      robin_(std::move(given.weights)) {
    const CellComplex& complex = given.space.relative.complex;
    const HodgeStars& stars = given.space.stars;
    const int k = mass_.degree();
    kept_ = given.space.relative.cells[k];
    check_positive_mass(mass_, side, degree);
    if (!(coefficient_ >= 0) || !std::isfinite(coefficient_))
        throw InvalidInput(fmt::format("a coefficient of diffusion of {} is given: expected a "
                                       "finite one of at least 0",
                                       coefficient_));
    solver_ = make_linear_solver(options.linear_solver);
    stiffness_ = symmetric_laplacian(complex, stars, k);
    if (robin_.size() > 0)
        stiffness_ = stiffness_ + Operator::weights(robin_);
    facts_ = {.symmetry = Symmetry::symmetric,
              .domain_dimension = complex.dimension(),
              .many_solves = true};
    is_mixed_ = k > 0 && !(mass_.is_diagonal() && stars[k - 1].is_diagonal());
    if (!is_mixed_ && laplacian_definiteness(stars, k) == Definiteness::semidefinite)
        facts_.definiteness = Definiteness::positive;
    space_ = Space{whole, all_stars, std::move(given.space)};
}

Diffusion::Diffusion(const HodgeStar& mass, const Operator& stiffness, Side side,
                     const std::string& linear_solver)
    : side_(side),
      degree_(side == Side::primal ? mass.degree() : mass.dimension() - mass.degree()),
      stiffness_(stiffness),
      mass_(mass),
      facts_{.symmetry = Symmetry::symmetric,
             .domain_dimension = mass.dimension(),
             .many_solves = true},
      solver_(make_linear_solver(linear_solver)) {
    if (stiffness.rows() != mass.size() || stiffness.cols() != mass.size())
        throw InvalidInput(fmt::format("a stiffness of {} x {} is given: expected {} x {}, as the "
                                       "star of {}-cells",
                                       stiffness.rows(), stiffness.cols(), mass.size(), mass.size(),
                                       mass.degree()));
    check_positive_mass(mass, side, degree_);
    for (Index cell = 0; cell < mass.size(); ++cell)
        kept_.push_back(cell);
}

SparseMatrix Diffusion::step_matrix(double gamma) const {
    const double t = gamma * coefficient_;
    if (is_mixed_)
        return mixed_step(space_->kept.relative.complex, space_->kept.stars, robin_, mass_.degree(),
                          t);
    return Operator::star(mass_) + t * stiffness_;
}

void Diffusion::prepare(double gamma) {
    const SparseMatrix A = step_matrix(gamma);
    unknowns_ = static_cast<Index>(A.rows());
    solver_->factorize(A, facts_);
}

Vector Diffusion::solve(const Vector& values, double explicit_part) const {
    // dual forms are stars of primal ones, and stars commute with the Laplacian
    const bool primal = side_ == Side::primal;
    const Vector w = primal ? values : mass_.solve(values);
    Vector right_side = mass_ * w;
    if (explicit_part > 0)
        right_side -= explicit_part * coefficient_ * (stiffness_ * w);
    right_side.conservativeResizeLike(Vector::Zero(unknowns_));
    const Vector next = solver_->solve(right_side).head(w.size());
    return primal ? next : mass_ * next;
}

Vector Diffusion::rate(const Vector& values) const {
    if (side_ == Side::dual)
        return -coefficient_ * (stiffness_ * mass_.solve(values));
    return -coefficient_ * mass_.solve(stiffness_ * values);
}

Vector Diffusion::boundary_rate(const Vector& boundary_values) const {
    const int k = mass_.degree();
    if (!space_)
        throw InvalidInput("a diffusion by a stiffness knows no boundary: add what it brings to "
                           "the rate");
    if (!mass_.is_diagonal() || (k > 0 && !space_->kept.stars[k - 1].is_diagonal()))
        throw InvalidInput(fmt::format("the star of {}-forms or that below is no diagonal: "
                                       "boundary values other than 0 need diagonal stars",
                                       k));
    if (side_ == Side::dual)
        return -coefficient_ * dual_load(boundary_values);
    return -coefficient_ * mass_.solve(primal_load(boundary_values));
}

/// What the stiffness of the whole makes of the fixed values, at the kept cells.
Vector Diffusion::primal_load(const Vector& boundary_values) const {
    const int k = mass_.degree();
    const RelativeComplex& kept = space_->kept.relative;
    check_size(boundary_values, space_->whole.size(k));
    const Vector fixed =
        boundary_values - kept.extend(k, Vector(kept.restrict(k, boundary_values)));
    Vector load = Vector::Zero(size());
    if (k < kept.complex.dimension()) {
        const Vector rise = Operator::derivative(space_->whole, k) * fixed;
        load += Operator::derivative(kept.complex, k).transposed() *
                Vector(space_->kept.stars[k + 1] * Vector(kept.restrict(k + 1, rise)));
    }
    if (k > 0) {
        const Vector flow = Operator::derivative(space_->whole, k - 1).transposed() *
                            Vector(space_->stars[k] * fixed);
        const Vector below = space_->kept.stars[k - 1].solve(Vector(kept.restrict(k - 1, flow)));
        load += mass_ * Vector(Operator::derivative(kept.complex, k - 1) * below);
    }
    return load;
}

/// What the boundary adds to the derivative of the dual form, and that to its codifferential.
Vector Diffusion::dual_load(const Vector& boundary_values) const {
    const int k = mass_.degree(), n = space_->whole.dimension();
    const RelativeComplex& kept = space_->kept.relative;
    if (k == 0)
        return Vector::Zero(size());
    if (kept.complex.size(n) < space_->whole.size(n))
        throw InvalidInput("an essential facet of the boundary has no dual: boundary values of "
                           "dual forms other than 0 need one at each");
    check_size(boundary_values, space_->whole.size(k - 1));
    const Vector added =
        (k % 2 == 0 ? 1 : -1) * (dual_boundary_derivative(space_->whole, n - k) * boundary_values);
    const Vector below = space_->kept.stars[k - 1].solve(Vector(kept.restrict(k - 1, added)));
    return mass_ * Vector(Operator::derivative(kept.complex, k - 1) * below);
}

} // namespace polydec
