// SPDX-License-Identifier: MIT
#include "solvers/heat.h"

#include "backends/registry.h"
#include "base/block_matrix.h"
#include "base/errors.h"
#include "dec/conditioned_complex.h"
#include "dec/forms/laplacian.h"
#include "solvers/spectra/positive_mass.h"

#include <fmt/format.h>

#include <cmath>

namespace polydec {

namespace {

RelativeComplex absolute(const CellComplex& complex) {
    return relative_complex(complex, essential_cells(complex, built_in_conditions(Side::primal)));
}

/// M_k + t d^T M_(k+1) d, and beside it t times d^T M_k and, negative, M_(k-1): of a form and its
/// codifferential. Quasi-definite, so that it has factors in every order.
SparseMatrix mixed_step(const CellComplex& complex, const HodgeStars& stars, int k, double t) {
    const Operator mass = Operator::star(stars[k]);
    const Operator below = Operator::derivative(complex, k - 1).transposed();
    Operator A = mass;
    if (k < complex.dimension()) {
        const Operator d = Operator::derivative(complex, k);
        A = A + t * (d.transposed() * Operator::star(stars[k + 1]) * d);
    }
    return block_matrix(A, t * (below * mass), -t * Operator::star(stars[k - 1]));
}

} // namespace

HeatSolver::HeatSolver(const CellComplex& complex, const HodgeStars& stars, Side side, int degree,
                       const HeatOptions& options)
    : HeatSolver(complex, ConditionedComplex{absolute(complex), stars}, side, degree, options) {}

HeatSolver::HeatSolver(const Discretization& mesh, const BoundaryConditions& conditions, Side side,
                       int degree, const HeatOptions& options)
    : HeatSolver(mesh.complex(), conditioned_complex(mesh, side, degree, conditions), side, degree,
                 options) {}

HeatSolver::HeatSolver(const CellComplex& complex, const HodgeStars& stars,
                       const BoundaryConditions& conditions, Side side, int degree,
                       const HeatOptions& options)
    : HeatSolver(complex, conditioned_complex(complex, stars, side, degree, conditions), side,
                 degree, options) {}

HeatSolver::HeatSolver(const CellComplex& whole, const ConditionedComplex& space, Side side,
                       int degree, const HeatOptions& options)
    : complex_(whole),
      side_(side),
      degree_(degree),
      stiffness_(Operator::zero(0, 0)),
      mass_(space.stars[cell_degree(whole, side, degree)]) {
    const CellComplex& complex = space.relative.complex;
    const HodgeStars& stars = space.stars;
    const int k = mass_.degree();
    kept_ = space.relative.cells[k];
    check_positive_mass(mass_, side, degree);
    if (!(options.time_step > 0) || !std::isfinite(options.time_step))
        throw InvalidInput(fmt::format("a time step of {} is given: expected a finite one above 0",
                                       options.time_step));
    const bool implicit = options.scheme == HeatScheme::backward_euler;
    const double implicit_part = implicit ? options.time_step : options.time_step / 2;
    explicit_part_ = options.time_step - implicit_part;
    solver_ = make_linear_solver(options.linear_solver);
    stiffness_ = symmetric_laplacian(complex, stars, k);
    SparseMatrix A;
    MatrixFacts facts{.symmetry = Symmetry::symmetric,
                      .domain_dimension = complex.dimension(),
                      .many_solves = true};
    if (k > 0 && !(mass_.is_diagonal() && stars[k - 1].is_diagonal()))
        A = mixed_step(complex, stars, k, implicit_part);
    else {
        A = Operator::star(mass_) + implicit_part * stiffness_;
        if (laplacian_definiteness(stars, k) == Definiteness::semidefinite)
            facts.definiteness = Definiteness::positive;
    }
    unknowns_ = static_cast<Index>(A.rows());
    solver_->factorize(A, facts);
}

Cochain HeatSolver::step(const Cochain& form) const {
    check(complex_, form);
    if (form.side != side_ || form.degree != degree_)
        throw InvalidInput(fmt::format("a {} {}-form is given: this solver is for {} {}-forms",
                                       name(form.side), form.degree, name(side_), degree_));
    // dual forms are stars of primal ones, and stars commute with the Laplacian
    const bool primal = side_ == Side::primal;
    const Vector values = form.values(kept_);
    const Vector w = primal ? values : mass_.solve(values);
    Vector right_side = mass_ * w;
    if (explicit_part_ > 0)
        right_side -= explicit_part_ * (stiffness_ * w);
    right_side.conservativeResizeLike(Vector::Zero(unknowns_));
    const Vector next = solver_->solve(right_side).head(w.size());
    Vector result = Vector::Zero(form.values.size());
    result(kept_) = primal ? next : mass_ * next;
    return {side_, degree_, std::move(result)};
}

} // namespace polydec
