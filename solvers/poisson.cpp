// SPDX-License-Identifier: MIT
#include "solvers/poisson.h"

#include "base/errors.h"
#include "dec/cell_centers.h"
#include "dec/circumsphere.h"
#include "dec/derivative.h"
#include "dec/dual_parts.h"
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

/// How values of a dual 0-form and boundary values act on each other through the facets.
struct DualFluxes {
    Vector weights;          ///< flux through a facet per difference of the values beside it
    std::vector<bool> fixed; ///< cells whose circumcenter lies on the boundary
    std::vector<bool> tied;  ///< cells beside a boundary facet through which something flows
    SparseMatrix load;       ///< boundary values to right-hand side, cells x facets
    SparseMatrix fix;        ///< boundary values to the values of fixed cells, cells x facets
};

void check_flux_is_defined(const Discretization& discretization, Index facet, double relative) {
    constexpr double rounding = 1e-12;
    if (relative > rounding)
        return;
    const int n = discretization.dimension();
    throw InvalidInput(fmt::format(
        "the dual of facet {} (vertices {}) has no length, so the flux through it is not defined: "
        "let cospherical cells be merged",
        facet, fmt::join(discretization.merging.vertices(n - 1, facet), ", ")));
}

/// The rows scaled to sum 1: several such facets of one cell meet at its circumcenter.
void average_rows(SparseMatrix& matrix) {
    for (Index row = 0; row < matrix.rows(); ++row) {
        const double sum = matrix.row(row).sum();
        for (SparseMatrix::InnerIterator entry(matrix, row); entry; ++entry)
            entry.valueRef() /= sum;
    }
}

DualFluxes dual_fluxes(const Discretization& discretization, const CellMarks& essential) {
    const auto& complex = discretization.complex();
    const auto& volumes = discretization.volumes;
    const int n = complex.dimension();
    const Index cells = complex.size(n), facets = complex.size(n - 1);
    const Vector scales = facet_scales(discretization);
    const IncidenceMatrix cofaces = complex.boundary(n);

    DualFluxes result{Vector::Zero(facets), std::vector<bool>(cells, false),
                      std::vector<bool>(cells, false), SparseMatrix(cells, facets),
                      SparseMatrix(cells, facets)};
    std::vector<Eigen::Triplet<double, Index>> load, fix;
    for (Index f = 0; f < facets; ++f) {
        const bool interior = complex.coface_counts(n - 1)[f] == 2;
        const Row coface(cofaces, f);
        // what flows through the natural boundary is given; nothing flows from a cell to itself
        if (!coface || (!interior && !essential[n - 1][f]))
            continue;
        const auto cell = static_cast<Index>(coface.col());
        const double dual = volumes.dual[n - 1][f];
        const double relative = scales[f] > 0 ? std::abs(dual) / scales[f] : 1;
        if (interior)
            check_flux_is_defined(discretization, f, relative);
        if (!interior && relative <= discretization.options.tolerance) {
            fix.emplace_back(cell, f, 1.0);
            result.fixed[cell] = true;
            continue;
        }
        result.weights[f] = volumes.primal[n - 1][f] / dual;
        if (!interior) {
            load.emplace_back(cell, f, result.weights[f]);
            result.tied[cell] = true;
        }
    }
    result.load.setFromTriplets(load.begin(), load.end());
    result.fix.setFromTriplets(fix.begin(), fix.end());
    average_rows(result.fix);
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

} // namespace

PoissonSolver::PoissonSolver(const Discretization& discretization, const PoissonOptions& options)
    : side_(options.side) {
    const auto essential = essential_cells(discretization.complex(), options.boundary);
    flux_sites_ = cell_centers(discretization.merging, discretization.points,
                               discretization.input_volumes, discretization.dimension() - 1);
    if (side_ == Side::primal)
        set_up_primal(discretization, essential, options.linear_solver);
    else
        set_up_dual(discretization, essential, options.linear_solver);
}

void PoissonSolver::set_up_primal(const Discretization& discretization, const CellMarks& essential,
                                  const std::string& engine) {
    const auto& complex = discretization.complex();
    const int n = complex.dimension();
    const Index size = complex.size(0);
    sites_ = cell_centers(discretization.merging, discretization.points,
                          discretization.input_volumes, 0);
    boundary_sites_ = sites_;
    mass_ = star(discretization.volumes, 0);

    Vector weights = star(discretization.volumes, 1);
    for (const Index edge : zero_star_cells(discretization.volumes, 1))
        weights[edge] = 0; // no more than rounding: the edge connects nothing
    ConstrainedSystem system{weighted_product(derivative(complex, 0), weights),
                             essential[0],
                             std::vector<bool>(size, false),
                             mass_.cwiseAbs(),
                             by_sign(weights),
                             n};
    // each piece of a facet is shared among its vertices as their duals divide it
    const SparseMatrix parts = dual_parts(discretization.input(), discretization.points,
                                          discretization.input_volumes, 0, n - 1);
    const SparseMatrix pieces = discretization.merging.diamond(n - 1).cast<double>().cwiseAbs();
    const SparseMatrix shares = natural_facets(complex, essential).asDiagonal() * pieces * parts;
    flux_load_ = shares.transpose();
    boundary_load_.resize(size, size);
    boundary_fix_.resize(size, size);
    boundary_fix_.setIdentity();
    solver_ = std::make_unique<ConstrainedSolver>(std::move(system), engine);
}

void PoissonSolver::set_up_dual(const Discretization& discretization, const CellMarks& essential,
                                const std::string& engine) {
    check_two_sided(discretization);
    const auto& complex = discretization.complex();
    const int n = complex.dimension();
    sites_ = cell_centers(discretization.merging, discretization.points,
                          discretization.input_volumes, n);
    boundary_sites_ = flux_sites_;
    mass_ = discretization.volumes.primal[n];

    auto fluxes = dual_fluxes(discretization, essential);
    boundary_load_ = std::move(fluxes.load);
    boundary_fix_ = std::move(fluxes.fix);
    const Vector areas =
        natural_facets(complex, essential).cwiseProduct(discretization.volumes.primal[n - 1]);
    flux_load_ = complex.boundary(n).transpose().cast<double>().cwiseAbs() * areas.asDiagonal();
    const SparseMatrix gradient = derivative(complex, n - 1).transpose();
    ConstrainedSystem system{weighted_product(gradient, fluxes.weights),
                             std::move(fluxes.fixed),
                             std::move(fluxes.tied),
                             mass_,
                             by_sign(fluxes.weights),
                             n};
    solver_ = std::make_unique<ConstrainedSolver>(std::move(system), engine);
}

Vector PoissonSolver::solve(const Vector& f, const Vector& boundary_values) {
    return solve(f, boundary_values, Vector::Zero(flux_sites_.rows()));
}

Vector PoissonSolver::solve(const Vector& f, const Vector& boundary_values,
                            const Vector& normal_derivatives) {
    check_values(f, sites_, "right-hand side");
    check_values(boundary_values, boundary_sites_, "boundary data");
    check_values(normal_derivatives, flux_sites_, "normal derivatives");
    const Vector load = boundary_load_ * boundary_values + flux_load_ * normal_derivatives;
    return solver_->solve(mass_.cwiseProduct(f) + load, boundary_fix_ * boundary_values);
}

} // namespace polydec
