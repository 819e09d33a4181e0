// SPDX-License-Identifier: MIT
#include "solvers/poisson.h"

#include "base/errors.h"
#include "dec/fields/cell_centers.h"
#include "dec/forms/gram.h"
#include "dec/forms/star.h"
#include "dec/metric/dual_parts.h"
#include "solvers/dual_fluxes.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace polydec {

namespace {

using Row = IncidenceMatrix::InnerIterator;

Definiteness by_sign(const Vector& weights) {
    return (weights.array() >= 0).all() ? Definiteness::semidefinite : Definiteness::indefinite;
}

/// A diag(weights) A^T; entries that cancel are no connections.
SparseMatrix connections(const IncidenceMatrix& A, const IncidenceMatrix& transposed,
                         const Vector& weights) {
    SparseMatrix result = gram(A, transposed, weights);
    result.prune(0.0);
    return result;
}

void check_values(const DenseMatrix& values, const Points& sites, const char* what) {
    if (values.rows() != sites.rows())
        throw InvalidInput(
            fmt::format("{}: {} values for {} places", what, values.rows(), sites.rows()));
    for (Index j = 0; j < values.cols(); ++j)
        for (Index i = 0; i < values.rows(); ++i)
            if (!std::isfinite(values(i, j)))
                throw InvalidInput(fmt::format("{}: value {} is {}", what, i, values(i, j)));
}

/// The data are numbers, but their products with volumes and weights need not be.
void check_loads(const DenseMatrix& loads, int degree) {
    for (Index j = 0; j < loads.cols(); ++j)
        for (Index i = 0; i < loads.rows(); ++i)
            if (!std::isfinite(loads(i, j)))
                throw InvalidInput(
                    fmt::format("the right-hand side of the system at {}-cell {} is {}: data times "
                                "volumes leave the range of numbers there; divide the right-hand "
                                "side, boundary data and normal derivatives by a power of two, and "
                                "multiply the solution by it",
                                degree, i, loads(i, j)));
}

/// What fixed unknowns take away from the right-hand sides of the others.
SparseMatrix load_of_fixed(const ConstrainedSystem& system) {
    SparseMatrix result = system.A;
    result.prune([&](Eigen::Index row, Eigen::Index column, double) {
        return system.fixed[column] && !system.fixed[row];
    });
    return result;
}

/// 1 for each facet that a natural condition concerns, 0 for the others.
Vector natural_facets(const CellComplex& complex, const CellMarks& essential) {
    const int n = complex.dimension();
    Vector result = Vector::Zero(complex.size(n - 1));
    for (Index f = 0; f < result.size(); ++f)
        if (complex.coface_counts(n - 1)[f] == 1 && !essential[n - 1][f])
            result[f] = 1;
    return result;
}

void check_conductivity(const CellComplex& complex, const Vector& conductivity) {
    const int n = complex.dimension();
    if (conductivity.size() != 0 && conductivity.size() != complex.size(n))
        throw InvalidInput(fmt::format("{} conductivities are given: expected one for each of the "
                                       "{} {}-cells, or none",
                                       conductivity.size(), complex.size(n), n));
    for (Index cell = 0; cell < conductivity.size(); ++cell)
        if (!(conductivity[cell] > 0 && std::isfinite(conductivity[cell])))
            throw InvalidInput(fmt::format("the conductivity of {}-cell {} is {}: expected a "
                                           "positive number",
                                           n, cell, conductivity[cell]));
}

/// star_1 with every part of a dual multiplied by the conductivity of the cell it lies in; 0 where
/// that is no more than rounding, because such an edge connects nothing.
Vector edge_weights(const Discretization& discretization, const Vector& conductivity) {
    if (conductivity.size() == 0) {
        Vector weights = star(discretization.volumes(), 1);
        for (const Index edge : zero_star_cells(discretization.volumes(), 1))
            weights[edge] = 0;
        return weights;
    }
    const auto& merging = discretization.merging();
    const auto& volumes = discretization.piece_volumes();
    const int n = discretization.dimension();
    const SparseMatrix parts = dual_parts(discretization.pieces(), discretization.metric(), volumes,
                                          1, n, discretization.options().centers);
    const SparseMatrix pieces = merging.diamond(n).cast<double>().cwiseAbs();
    const SparseMatrix edges = merging.diamond(1).cast<double>().cwiseAbs();
    const Vector of_pieces = pieces.transpose() * conductivity;
    const Vector& lengths = discretization.volumes().primal(1);
    const auto over_squares = [&](const Vector& of_input_edges) -> Vector {
        return (edges * of_input_edges).cwiseQuotient(lengths).cwiseQuotient(lengths);
    };
    Vector weights = over_squares(volumes.primal(1).cwiseProduct(parts.transpose() * of_pieces));

    // |e| times its part of t is of the size of t, or larger where such terms cancel
    const SparseMatrix around = parts.cwiseAbs();
    SparseMatrix where = parts;
    where.coeffs().setOnes();
    const Vector sizes =
        over_squares(volumes.primal(1).cwiseProduct(around.transpose() * of_pieces) +
                     where.transpose() * of_pieces.cwiseProduct(volumes.primal(n)));
    constexpr double rounding = 1e-12;
    return (weights.array().abs() <= rounding * sizes.array()).select(0, weights);
}

/// What each vertex gets of the (n-1)-cells that count: each piece is shared among its vertices as
/// their duals divide it.
SparseMatrix shares_of_vertices(const Discretization& discretization, const Vector& counts) {
    const int n = discretization.dimension();
    if (counts.isZero(0))
        return SparseMatrix(discretization.complex().size(0), counts.size());
    const SparseMatrix parts =
        dual_parts(discretization.pieces(), discretization.metric(), discretization.piece_volumes(),
                   0, n - 1, discretization.options().centers);
    const SparseMatrix pieces = discretization.merging().diamond(n - 1).cast<double>().cwiseAbs();
    const SparseMatrix shares = counts.asDiagonal() * pieces * parts;
    return shares.transpose();
}

} // namespace

PoissonSolver::PoissonSolver(const Discretization& discretization, const PoissonOptions& options)
    : side_(options.side), degree_(options.side == Side::primal ? 0 : discretization.dimension()) {
    const auto essential = essential_cells(discretization.complex(), options.boundary);
    check_conductivity(discretization.complex(), options.conductivity);
    flux_sites_ = cell_centers(discretization, discretization.dimension() - 1);
    if (side_ == Side::primal)
        set_up_primal(discretization, essential, options);
    else
        set_up_dual(discretization, essential, options);
}

void PoissonSolver::set_up_primal(const Discretization& discretization, const CellMarks& essential,
                                  const PoissonOptions& options) {
    const auto& complex = discretization.complex();
    const int n = complex.dimension();
    const Index size = complex.size(0);
    sites_ = cell_centers(discretization, 0);
    boundary_sites_ = sites_;
    mass_ = star(discretization.volumes(), 0);

    const Vector weights = edge_weights(discretization, options.conductivity);
    ConstrainedSystem system{connections(complex.boundary(1), complex.coboundary(0), weights),
                             essential[0],
                             std::vector<bool>(size, false),
                             mass_.cwiseAbs(),
                             by_sign(weights),
                             n};
    flux_load_ = shares_of_vertices(discretization, natural_facets(complex, essential));
    boundary_load_.resize(size, size);
    boundary_fix_.resize(size, size);
    boundary_fix_.setIdentity();
    fixed_load_ = load_of_fixed(system);
    solver_ = std::make_unique<ConstrainedSolver>(std::move(system), options.linear_solver);
}

void PoissonSolver::set_up_dual(const Discretization& discretization, const CellMarks& essential,
                                const PoissonOptions& options) {
    const auto& complex = discretization.complex();
    const int n = complex.dimension();
    sites_ = cell_centers(discretization, n);
    boundary_sites_ = flux_sites_;
    mass_ = discretization.volumes().primal(n);

    auto fluxes = dual_fluxes(discretization, essential, options.conductivity);
    boundary_load_ = std::move(fluxes.load);
    boundary_fix_ = std::move(fluxes.fix);
    const Vector areas =
        natural_facets(complex, essential).cwiseProduct(discretization.volumes().primal(n - 1));
    flux_load_ = complex.boundary(n).transpose().cast<double>().cwiseAbs() * areas.asDiagonal();
    ConstrainedSystem system{
        connections(complex.coboundary(n - 1), complex.boundary(n), fluxes.weights),
        std::move(fluxes.fixed),
        std::move(fluxes.tied),
        mass_,
        by_sign(fluxes.weights),
        n};
    fixed_load_ = load_of_fixed(system);
    solver_ = std::make_unique<ConstrainedSolver>(std::move(system), options.linear_solver);
}

Vector PoissonSolver::solve(const Vector& f, const Vector& boundary_values) {
    return solve(f, boundary_values, Vector::Zero(flux_sites_.rows()));
}

Vector PoissonSolver::solve(const Vector& f, const Vector& boundary_values,
                            const Vector& normal_derivatives) {
    return solve_columns(f, boundary_values, normal_derivatives);
}

DenseMatrix PoissonSolver::solve_columns(const DenseMatrix& f, const DenseMatrix& boundary_values,
                                         const DenseMatrix& normal_derivatives) {
    if (f.cols() != boundary_values.cols() || f.cols() != normal_derivatives.cols())
        throw InvalidInput(fmt::format("{} right-hand sides, boundary data for {} and normal "
                                       "derivatives for {} problems are given: expected as many",
                                       f.cols(), boundary_values.cols(),
                                       normal_derivatives.cols()));
    check_values(f, sites_, "right-hand side");
    check_values(boundary_values, boundary_sites_, "boundary data");
    check_values(normal_derivatives, flux_sites_, "normal derivatives");
    const DenseMatrix load = boundary_load_ * boundary_values + flux_load_ * normal_derivatives;
    const DenseMatrix right_side = mass_.asDiagonal() * f + load;
    const DenseMatrix fixed = boundary_fix_ * boundary_values;
    check_loads(right_side, degree_);
    check_loads(right_side - fixed_load_ * fixed, degree_);
    return solver_->solve(right_side, fixed);
}

} // namespace polydec
