// SPDX-License-Identifier: MIT
#include "solvers/heat.h"

#include "backends/registry.h"
#include "base/errors.h"
#include "dec/conditioned_complex.h"
#include "dec/forms/laplacian.h"
#include "solvers/spectra/positive_mass.h"

#include <fmt/format.h>

namespace polydec {

namespace {

RelativeComplex absolute(const CellComplex& complex) {
    return relative_complex(complex, essential_cells(complex, built_in_conditions(Side::primal)));
}

/// M_k + t d^T M_(k+1) d, and beside it t times d^T M_k and, negative, M_(k-1): of a form and its
/// codifferential. Quasi-definite, so that it has factors in every order.
SparseMatrix mixed_step(const CellComplex& complex, const HodgeStars& stars, int k, double t) {
    SparseMatrix A = stars[k].matrix();
    if (k < complex.dimension()) {
        const Operator d = Operator::derivative(complex, k);
        A += t * (d.transposed() * Operator::star(stars[k + 1]) * d).matrix();
    }
    const Operator below = Operator::derivative(complex, k - 1).transposed();
    const SparseMatrix B = t * (below * Operator::star(stars[k])).matrix();
    const SparseMatrix M = t * stars[k - 1].matrix();
    const auto size = static_cast<Index>(A.rows());
    std::vector<Eigen::Triplet<double, Index>> entries;
    for (Index i = 0; i < size; ++i)
        for (SparseMatrix::InnerIterator entry(A, i); entry; ++entry)
            entries.emplace_back(i, entry.col(), entry.value());
    for (Index i = 0; i < B.rows(); ++i) {
        for (SparseMatrix::InnerIterator entry(B, i); entry; ++entry) {
            entries.emplace_back(size + i, entry.col(), entry.value());
            entries.emplace_back(entry.col(), size + i, entry.value());
        }
        for (SparseMatrix::InnerIterator entry(M, i); entry; ++entry)
            entries.emplace_back(size + i, size + entry.col(), -entry.value());
    }
    SparseMatrix result(size + B.rows(), size + B.rows());
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
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
      applied_(Operator::zero(0, 0)),
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
    applied_ = symmetric_laplacian(complex, stars, k);
    unknowns_ = mass_.size();
    if (k > 0 && !stars[k - 1].is_diagonal()) {
        unknowns_ += stars[k - 1].size();
        solver_->factorize(mixed_step(complex, stars, k, implicit_part),
                           {.symmetry = Symmetry::symmetric,
                            .domain_dimension = complex.dimension(),
                            .many_solves = true});
        return;
    }
    stiffness_ = applied_;
    SparseMatrix A = mass_.matrix();
    A += implicit_part * stiffness_;
    const bool definite = laplacian_definiteness(stars, k) == Definiteness::semidefinite;
    solver_->factorize(
        A, {.symmetry = Symmetry::symmetric,
            .definiteness = definite ? Definiteness::positive : Definiteness::indefinite,
            .domain_dimension = complex.dimension(),
            .many_solves = true});
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
    const bool is_mixed = unknowns_ > mass_.size();
    Vector right_side = mass_ * w;
    if (!is_mixed)
        right_side -= explicit_part_ * (stiffness_ * w);
    else if (explicit_part_ > 0)
        right_side -= explicit_part_ * (applied_ * w);
    right_side.conservativeResizeLike(Vector::Zero(unknowns_));
    const Vector next = solver_->solve(right_side).head(w.size());
    Vector result = Vector::Zero(form.values.size());
    result(kept_) = primal ? next : mass_ * next;
    return {side_, degree_, std::move(result)};
}

} // namespace polydec
