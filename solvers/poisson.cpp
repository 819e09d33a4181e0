// SPDX-License-Identifier: MIT
#include "solvers/poisson.h"

#include "base/errors.h"
#include "complex/components.h"
#include "dec/cell_centers.h"
#include "dec/circumsphere.h"
#include "dec/derivative.h"
#include "dec/star.h"

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

/// d^T weights d or, given d^T, d weights d^T; entries that cancel are no connections.
SparseMatrix weighted_product(const SparseMatrix& d, const Vector& weights) {
    const SparseMatrix left = SparseMatrix(d.transpose()) * weights.asDiagonal();
    SparseMatrix A = left * d;
    A.prune(0.0);
    return A;
}

void check_values(const Vector& values, const Points& sites, const char* what) {
    if (values.size() != sites.rows())
        throw InvalidInput(
            fmt::format("{}: {} values for {} places", what, values.size(), sites.rows()));
    for (Index i = 0; i < values.size(); ++i)
        if (!std::isfinite(values[i]))
            throw InvalidInput(fmt::format("{}: value {} is {}", what, i, values[i]));
}

/// Dual 0-forms are functions only where every facet separates at most two cells that agree on its
/// sides.
void check_two_sided(const Discretization& discretization) {
    const auto& complex = discretization.complex();
    const int n = complex.dimension();
    if (!discretization.input().orientable())
        throw InvalidInput("the mesh is non-orientable, so dual 0-forms change sign around it: "
                           "solve for primal 0-forms");
    const auto& counts = complex.coface_counts(n - 1);
    const auto branching =
        std::find_if(counts.begin(), counts.end(), [](Index c) { return c > 2; });
    if (branching != counts.end())
        throw InvalidInput(fmt::format(
            "{} cells meet at facet {} (vertices {}), so the flux through it is not a difference "
            "of two values: solve for primal 0-forms",
            *branching, branching - counts.begin(),
            fmt::join(discretization.merging.vertices(
                          n - 1, static_cast<Index>(branching - counts.begin())),
                      ", ")));
}

/// Twice the circumradius of each merged facet: the length its dual is compared with.
Vector facet_scales(const Discretization& discretization) {
    const int n = discretization.dimension();
    const Vector radii =
        circumradii(discretization.points, discretization.input().simplices(n - 1));
    Vector scales = Vector::Zero(discretization.complex().size(n - 1));
    for (Index f = 0; f < scales.size(); ++f)
        for (Row piece(discretization.merging.diamond(n - 1), f); piece; ++piece)
            scales[f] = std::max(scales[f], 2 * radii[piece.col()]);
    return scales;
}

} // namespace

PoissonSolver::PoissonSolver(const Discretization& discretization, const PoissonOptions& options)
    : side_(options.side) {
    if (side_ == Side::primal)
        set_up_primal(discretization, options);
    else
        set_up_dual(discretization, options);
}

void PoissonSolver::set_up_primal(const Discretization& discretization,
                                  const PoissonOptions& options) {
    const auto& complex = discretization.complex();
    const Index size = complex.size(0);
    sites_ = cell_centers(discretization.merging, discretization.points,
                          discretization.input_volumes, 0);
    boundary_sites_ = sites_;
    mass_ = star(discretization.volumes, 0);

    Vector weights = star(discretization.volumes, 1);
    for (const Index edge : zero_star_cells(discretization.volumes, 1))
        weights[edge] = 0; // no more than rounding: the edge connects nothing
    ConstrainedSystem system{weighted_product(derivative(complex, 0), weights),
                             std::vector<bool>(size, false),
                             std::vector<bool>(size, false),
                             mass_.cwiseAbs(),
                             by_sign(weights),
                             complex.dimension()};
    if (options.boundary == BoundaryCondition::dirichlet)
        system.fixed = boundary_cells(complex)[0];
    boundary_load_.resize(size, size);
    boundary_fix_.resize(size, size);
    boundary_fix_.setIdentity();
    solver_ = std::make_unique<ConstrainedSolver>(std::move(system), options.linear_solver);
}

void PoissonSolver::set_up_dual(const Discretization& discretization,
                                const PoissonOptions& options) {
    check_two_sided(discretization);
    const auto& complex = discretization.complex();
    const int n = complex.dimension();
    const Index cells = complex.size(n), facets = complex.size(n - 1);
    const auto& volumes = discretization.volumes;
    sites_ = cell_centers(discretization.merging, discretization.points,
                          discretization.input_volumes, n);
    boundary_sites_ = cell_centers(discretization.merging, discretization.points,
                                   discretization.input_volumes, n - 1);
    mass_ = volumes.primal[n];

    // flux through a facet per difference of values; a boundary dual without length fixes its cell
    const Vector scales = facet_scales(discretization);
    const IncidenceMatrix cofaces = complex.boundary(n);
    Vector weights = Vector::Zero(facets);
    std::vector<bool> fixed(cells, false), tied(cells, false);
    std::vector<Eigen::Triplet<double, Index>> load, fix;
    for (Index f = 0; f < facets; ++f) {
        const double dual = volumes.dual[n - 1][f], primal = volumes.primal[n - 1][f];
        const bool interior = complex.coface_counts(n - 1)[f] == 2;
        if (!interior && options.boundary == BoundaryCondition::natural)
            continue;
        const Row coface(cofaces, f);
        if (!coface)
            continue; // the same cell on both sides
        const double relative = scales[f] > 0 ? std::abs(dual) / scales[f] : 1;
        if (interior && relative <= 1e-12)
            throw InvalidInput(fmt::format(
                "the dual of facet {} (vertices {}) has no length, so the flux through it is not "
                "defined: let cospherical cells be merged",
                f, fmt::join(discretization.merging.vertices(n - 1, f), ", ")));
        const auto cell = static_cast<Index>(coface.col());
        if (!interior && relative <= discretization.options.tolerance) {
            fix.emplace_back(cell, f, 1.0);
            fixed[cell] = true;
            continue;
        }
        weights[f] = primal / dual;
        if (!interior) {
            load.emplace_back(cell, f, weights[f]);
            tied[cell] = true;
        }
    }
    boundary_load_.resize(cells, facets);
    boundary_load_.setFromTriplets(load.begin(), load.end());
    boundary_fix_.resize(cells, facets);
    boundary_fix_.setFromTriplets(fix.begin(), fix.end());
    // several such facets of one cell meet at its circumcenter
    for (Index cell = 0; cell < cells; ++cell) {
        const auto facets_of_cell = boundary_fix_.row(cell).nonZeros();
        for (SparseMatrix::InnerIterator entry(boundary_fix_, cell); entry; ++entry)
            entry.valueRef() = 1.0 / static_cast<double>(facets_of_cell);
    }

    const SparseMatrix gradient = derivative(complex, n - 1).transpose();
    ConstrainedSystem system{weighted_product(gradient, weights),
                             std::move(fixed),
                             std::move(tied),
                             mass_,
                             by_sign(weights),
                             n};
    solver_ = std::make_unique<ConstrainedSolver>(std::move(system), options.linear_solver);
}

Vector PoissonSolver::solve(const Vector& f, const Vector& boundary_values) {
    check_values(f, sites_, "right-hand side");
    check_values(boundary_values, boundary_sites_, "boundary data");
    const Vector load = boundary_load_ * boundary_values;
    return solver_->solve(mass_.cwiseProduct(f) + load, boundary_fix_ * boundary_values);
}

} // namespace polydec
