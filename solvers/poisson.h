// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/forms/boundary_conditions.h"
#include "dec/forms/side.h"
#include "solvers/constrained_system.h"

namespace polydec {

struct PoissonOptions {
    Side side = Side::primal;
    /// Essential: u is given (Dirichlet); natural: its normal derivative is (Neumann). The same on
    /// both sides; without more, u is given everywhere.
    BoundaryConditions boundary = {};
    std::string linear_solver = "auto";
    Vector conductivity = {}; ///< kappa > 0 of each merged n-cell; empty: 1 everywhere
};

/// Solves -div kappa grad u = f for primal 0-forms (values at vertices) or dual 0-forms (values at
/// the cells' circumcenters), with kappa = 1 Delta u = f, with one factorization.
///
/// Primal, essential: values at the vertices of these facets are fixed. Dual, essential: a boundary
/// facet's dual reaches from the cell's circumcenter to the facet's, where the boundary value is;
/// where it has no length the cell's value is the boundary value. Natural: what flows through the
/// facet enters the right-hand side. Components without an essential facet have the solution of
/// mean 0, and the mean of the data is removed there. No star is inverted that need not be.
///
/// Primal, an edge connects its ends by the parts of its dual in the n-simplices around it, each
/// times its conductivity, over the edge's length; on triangles these are linear finite elements,
/// whatever was merged.
class PoissonSolver {
public:
    /// Throws InvalidInput, naming the facets, if dual 0-forms are asked for on a complex that is
    /// non-orientable or branching, or where an interior dual has no length, or if the conditions
    /// do not fit the facets.
    PoissonSolver(const Discretization& discretization, const PoissonOptions& options = {});

    /// Where f has its values, one row of coordinates each: vertices or circumcenters of n-cells.
    const Points& sites() const& { return sites_; }
    /// Where boundary values are asked for: vertices (those off the boundary do not matter), or
    /// circumcenters of facets (those with two cofaces do not matter).
    const Points& boundary_sites() const& { return boundary_sites_; }
    /// Where normal derivatives are asked for: circumcenters of facets (only those with a natural
    /// condition matter).
    const Points& flux_sites() const& { return flux_sites_; }
    Points sites() && { return std::move(sites_); }
    Points boundary_sites() && { return std::move(boundary_sites_); }
    Points flux_sites() && { return std::move(flux_sites_); }

    /// f at sites(), u on the essential part of the boundary at boundary_sites(), its derivative
    /// along the outward normal, times kappa, on the natural part at flux_sites(), by default 0;
    /// all finite. u at sites(). Throws InvalidInput, naming the cell, where the right-hand side of
    /// the system that these make is no number.
    Vector solve(const Vector& f, const Vector& boundary_values);
    Vector solve(const Vector& f, const Vector& boundary_values, const Vector& normal_derivatives);

    /// The same for several problems, a column each.
    template <SeveralColumns F, SeveralColumns Values>
    DenseMatrix solve(const Eigen::MatrixBase<F>& f,
                      const Eigen::MatrixBase<Values>& boundary_values) {
        return solve_columns(f, boundary_values,
                             DenseMatrix::Zero(flux_sites_.rows(), boundary_values.cols()));
    }
    template <SeveralColumns F, SeveralColumns Values, SeveralColumns Derivatives>
    DenseMatrix solve(const Eigen::MatrixBase<F>& f,
                      const Eigen::MatrixBase<Values>& boundary_values,
                      const Eigen::MatrixBase<Derivatives>& normal_derivatives) {
        return solve_columns(f, boundary_values, normal_derivatives);
    }

    /// Of the last solve; of several problems the worst.
    double residual() const { return solver_->residual(); }
    const SolveReport& report() const { return solver_->report(); }
    const Compatibility& compatibility() const { return solver_->compatibility(); }

private:
    DenseMatrix solve_columns(const DenseMatrix& f, const DenseMatrix& boundary_values,
                              const DenseMatrix& normal_derivatives);
    void set_up_primal(const Discretization& discretization, const CellMarks& essential,
                       const PoissonOptions& options);
    void set_up_dual(const Discretization& discretization, const CellMarks& essential,
                     const PoissonOptions& options);

    Side side_;
    int degree_; // of the cells that values belong to
    Points sites_, boundary_sites_, flux_sites_;
    Vector mass_;                // volume that each value of f stands for
    SparseMatrix boundary_load_; // boundary values to right-hand side
    SparseMatrix boundary_fix_;  // boundary values to fixed unknowns
    SparseMatrix fixed_load_;    // fixed unknowns to right-hand side, for those that are not
    SparseMatrix flux_load_;     // normal derivatives to right-hand side
    std::unique_ptr<ConstrainedSolver> solver_;
};

} // namespace polydec
