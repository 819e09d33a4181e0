// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/side.h"
#include "solvers/constrained_system.h"

namespace polydec {

/// What is known on the boundary: the solution's values, or that nothing flows through it.
enum class BoundaryCondition { dirichlet, natural };

struct PoissonOptions {
    Side side = Side::primal;
    BoundaryCondition boundary = BoundaryCondition::dirichlet;
    std::string linear_solver = "auto";
};

/// Solves Delta u = f for primal 0-forms (values at vertices) or dual 0-forms (values at the cells'
/// circumcenters), Delta = -div grad the positive Laplacian, with one factorization.
///
/// Primal, Dirichlet: values at boundary vertices are fixed. Dual, Dirichlet: a boundary facet's
/// dual reaches from the cell's circumcenter to the facet's, where the boundary value is; where it
/// has no length the cell's value is the boundary value. Components without boundary data have the
/// solution of mean 0, and the mean of f is removed there. No star is inverted that need not be.
class PoissonSolver {
public:
    /// Throws InvalidInput, naming the facets, if dual 0-forms are asked for on a complex that is
    /// non-orientable or branching, or where an interior dual has no length.
    PoissonSolver(const Discretization& discretization, const PoissonOptions& options = {});

    /// Where f has its values, one row of coordinates each: vertices or circumcenters of n-cells.
    const Points& sites() const { return sites_; }
    /// Where boundary values are asked for: vertices (those off the boundary do not matter), or
    /// circumcenters of facets (those with two cofaces do not matter).
    const Points& boundary_sites() const { return boundary_sites_; }

    /// f at sites(), boundary values at boundary_sites(); both finite. u at sites().
    Vector solve(const Vector& f, const Vector& boundary_values);

    /// Of the last solve.
    double residual() const { return solver_->residual(); }
    const SolveReport& report() const { return solver_->report(); }
    const Compatibility& compatibility() const { return solver_->compatibility(); }

private:
    void set_up_primal(const Discretization& discretization, const PoissonOptions& options);
    void set_up_dual(const Discretization& discretization, const PoissonOptions& options);

    Side side_;
    Points sites_, boundary_sites_;
    Vector mass_;                // volume that each value of f stands for
    SparseMatrix boundary_load_; // boundary values to right-hand side
    SparseMatrix boundary_fix_;  // boundary values to fixed unknowns
    std::unique_ptr<ConstrainedSolver> solver_;
};

} // namespace polydec
