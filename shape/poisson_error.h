// SPDX-License-Identifier: MIT
#pragma once

#include "shape/shape.h"

#include <optional>
#include <string>
#include <vector>

namespace polydec {

/// -div(kappa grad u) = f on a shape, with data as its simplices have them: f constant or linear on
/// each, values on essential facets linear, flow constant on each of the others.
struct PoissonProblem {
    Shape shape;
    /// A row for each n-simplex: f there, or its values at the n+1 corners.
    DenseMatrix source;
    /// Of facets: kappa du/dnu where the condition is natural, with alpha u added where it is
    /// Robin's. Empty: 0. Other facets do not matter.
    Vector flow = {};
};

/// The problem on the simplices of a mesh, by what PoissonSolver on the primal side takes: f at
/// vertices, between which it counts as linear, and flow at facets. Throws InvalidInput like
/// shape_of, and where a vertex is inside of a merged cell.
PoissonProblem poisson_problem(const Discretization& mesh, const BoundaryConditions& conditions,
                               const CellData& conductivity, const Vector& f, const Vector& flow);

/// How far linear functions u_h are from the solution u at most. Norms are those of L2 on the
/// shape.
struct PoissonError {
    double energy = 0; ///< of kappa^(1/2) grad (u - u_h), with Robin's alpha^(1/2) (u - u_h)
    /// Of kappa^(1/2) grad u less half of that of u_h and half of kappa^(-1/2) sigma.
    double averaged_gradient = 0;
    double size = 0;            ///< the norm of kappa^(1/2) grad u_h itself
    double oscillation = 0;     ///< the share that linear parts of f have in these
    std::optional<double> l2{}; ///< of u - u_h, up to constants where u is so; see below
    Vector shares{};            ///< of n-simplices in the square of `energy`; their sum is 1, or 0
    /// The averaged gradient in each n-simplex: the sum over corners i of column i times grad
    /// lambda_i, plus the last column times (x - center).
    DenseMatrix gradients{};
    std::vector<std::string> warnings{}; ///< why there is no l2
};

struct PoissonErrorOptions {
    bool l2 = true; ///< costs a count of inertia of more than twice the size
    std::string linear_solver = "auto";
};

/// The error of a function that is linear on simplices, with these values at the vertices of the
/// pieces, from the solution that has its values on essential facets: proved, however it was
/// found. A flux sigma with -div sigma = f - mean over each simplex, continuous across facets and
/// with the flow given, comes from one solve with Crouzeix-Raviart functions (Marini 1985); the
/// error in energy is at most its distance from kappa grad u_h (Prager, Synge 1947), and that of
/// the average is half of this. L2: a constant M with |u - u_h| <= M times the energy, for
/// Galerkin's u_h, is proved by a count of inertia (Liu, Oishi 2013); how far u_h is from
/// Galerkin's is added. Where a component has neither essential nor Robin facets, f counts less its
/// mean there, with what flows in. Proofs: docs/what-is-proved.md. Throws InvalidInput for numbers
/// that do not fit, are none, or functions that are twisted; SolverFailure if an engine does not
/// deliver.
PoissonError poisson_error(const PoissonProblem& problem, const Vector& values,
                           const PoissonErrorOptions& options = {});

/// A number between two bounds, and the best guess.
struct Enclosed {
    double lower, value, upper;
};

/// The integral of g u over the shape, g being given as the source of a problem is, for the
/// solution u which `values` are near to: by errors of both, u's and of the solution for g as
/// source (Ainsworth, Rankin 2012). Throws InvalidInput like poisson_error, and where a component
/// has neither essential nor Robin facets.
Enclosed goal_interval(const PoissonProblem& problem, const Vector& values, const DenseMatrix& goal,
                       const PoissonErrorOptions& options = {});

} // namespace polydec
