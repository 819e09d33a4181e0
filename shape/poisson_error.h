// SPDX-License-Identifier: MIT
#pragma once

#include "shape/shape.h"

#include <optional>
#include <string>
#include <vector>

namespace polydec {

/// The problem -div(kappa grad u) = f on a shape, with data on its simplices: f is constant or
/// linear on each, values on essential facets are linear, flow is constant on each other facet.
struct PoissonProblem {
    Shape shape;
    /// A row for each n-simplex: the value of f, or its values at the n+1 corners.
    DenseMatrix source;
    /// Per facet: kappa du/dnu on natural facets, kappa du/dnu + alpha u on Robin facets. Empty: 0.
    /// Values on other facets are ignored.
    Vector flow = {};
};

/// The problem on the simplices of a mesh, from data that PoissonSolver takes on the primal side: f
/// at vertices, linear between them, and flow at facets. Throws InvalidInput like shape_of, and if
/// a vertex is inside a merged cell.
PoissonProblem poisson_problem(const Discretization& mesh, const BoundaryConditions& conditions,
                               const CellData& conductivity, const Vector& f, const Vector& flow);

/// Bounds on the error of linear functions u_h against the solution u. Norms are L2 norms on the
/// shape.
struct PoissonError {
    double energy = 0; ///< of kappa^(1/2) grad (u - u_h), with Robin's alpha^(1/2) (u - u_h)
    /// Of kappa^(1/2) grad u minus the mean of kappa^(1/2) grad u_h and kappa^(-1/2) sigma.
    double averaged_gradient = 0;
    double size = 0;            ///< the norm of kappa^(1/2) grad u_h itself
    double oscillation = 0;     ///< the part of these due to linear parts of f
    std::optional<double> l2{}; ///< of u - u_h, up to constants if u is; see below
    Vector shares{};            ///< of n-simplices in the square of `energy`; their sum is 1, or 0
    /// The averaged gradient in each n-simplex: the sum over corners i of column i times grad
    /// lambda_i, plus the last column times (x - center).
    DenseMatrix gradients{};
    std::vector<std::string> warnings{}; ///< reasons for a missing l2, unless the limit is 0
};

struct PoissonErrorOptions {
    /// Simplices up to which l2 is proved, which costs an inertia count of more than twice the
    /// size; 0: never.
    Index l2_limit = 50'000;
    std::string linear_solver = "auto";
};

/// Bounds the error of a function that is linear on simplices, given by values at the vertices of
/// the pieces, against the solution with the same values on essential facets. The bound is proved
/// for any such function. One solve with Crouzeix-Raviart functions (Marini 1985) gives a flux
/// sigma with -div sigma = f - mean over each simplex, continuous across facets and with the given
/// flow. The energy error is at most the distance of sigma from kappa grad u_h (Prager, Synge
/// 1947); the averaged gradient has half this error. L2: an inertia count proves a constant M with
/// |u - u_h| <= M times the energy error for the Galerkin u_h (Liu, Oishi 2013); the distance of
/// u_h from Galerkin's is added. On a component without essential or Robin facets, the mean of f,
/// with the inflow, is subtracted. Proofs: docs/what-is-proved.md. Throws InvalidInput for wrong
/// sizes, values that are not finite, and twisted functions; SolverFailure if an engine fails.
PoissonError poisson_error(const PoissonProblem& problem, const Vector& values,
                           const PoissonErrorOptions& options = {});

/// A number between two bounds, and the best guess.
struct Enclosed {
    double lower, value, upper;
};

/// Bounds the integral of g u over the shape, where u is the solution approximated by `values` and
/// g is given like a problem's source. Combines the errors of u and of the solution with source g
/// (Ainsworth, Rankin 2012). The bounds hold for every shape that the errors of lengths allow.
/// Throws InvalidInput like poisson_error, if these errors hide the goal, and if a component has
/// neither essential nor Robin facets.
Enclosed goal_interval(const PoissonProblem& problem, const Vector& values, const DenseMatrix& goal,
                       const PoissonErrorOptions& options = {});

} // namespace polydec
