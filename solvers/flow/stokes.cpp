// SPDX-License-Identifier: MIT
#include "solvers/flow/stokes.h"

#include "base/checks.h"
#include "base/errors.h"
#include "complex/homology.h"
#include "dec/discretization/positive_mass.h"
#include "dec/forms/cochain.h"
#include "solvers/flow/flow_spaces.h"
#include "solvers/sources/saddle_solver.h"

#include <fmt/format.h>

#include <utility>

namespace polydec {

namespace {

/// Throws InvalidInput if there are flows without vorticity, divergence and pressure: those around
/// holes and between facets with known pressure, which a wall without slip holds back.
void check_held_back(const CellComplex& complex, const FlowSpaces& spaces) {
    const int n = complex.dimension();
    for (const BoundaryFacet& on : spaces.open)
        if (spaces.vorticity.fixed()[n - 1][on.facet])
            throw InvalidInput(
                fmt::format(
                    "facet {} is open and without vorticity, which does not determine a slow flow: "
                    "give the pressure and the velocity along the facet (FlowBoundary::pressure)",
                    on.facet),
                {.degree = n - 1, .cells = {on.facet}});
    CellMarks left_out = spaces.flux.fixed();
    std::vector<bool> sticks(complex.size(n), false);
    for (const BoundaryFacet& on : spaces.dragged)
        if (left_out[n - 1][on.facet])
            sticks[on.cell] = true;
    const FreeComponents loose(spaces.divergence.transpose(),
                               std::vector<bool>(sticks.size(), false), sticks,
                               Vector::Ones(complex.size(n)));
    if (loose.count() == 0)
        return;
    for (Index t = 0; t < complex.size(n); ++t)
        left_out[n][t] = loose.of(t) < 0;
    mark_faces(complex, left_out);
    const Index free = betti_numbers(relative_complex(complex, left_out).complex)[n - 1];
    if (free > 0)
        throw InvalidInput(
            fmt::format("{} flows around holes or between open facets meet no resistance, so the "
                        "solution is not unique: expected a wall without slip",
                        free));
}

/// Blocks of constraints on a flux: its turn, and its divergence.
SparseMatrix stacked(const SparseMatrix& above, const SparseMatrix& below) {
    std::vector<Eigen::Triplet<double, Index>> entries;
    for (const auto* A : {&above, &below})
        for (Index row = 0; row < A->rows(); ++row)
            for (SparseMatrix::InnerIterator entry(*A, row); entry; ++entry)
                entries.emplace_back(row + (A == &below ? above.rows() : 0), entry.col(),
                                     entry.value());
    SparseMatrix result(above.rows() + below.rows(), above.cols());
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}

/// The matrix above, nothing below.
SparseMatrix padded(SparseMatrix A, Index more) {
    A.conservativeResize(A.rows() + more, A.cols() + more);
    return A;
}

Vector or_zeros(const char* what, const Vector& values, Eigen::Index size) {
    if (values.size() == 0)
        return Vector::Zero(size);
    check_values(what, values, size);
    return values;
}

} // namespace

/// Of u and (w, -p): nu d^T M_n d u + nu M d w - d^T p, which fixes the divergence twice, so that
/// the upper block is not empty; and the turn and the divergence of u.
struct StokesSolver::System : FlowUnits {
    Cells cells;
    int n;
    double viscosity;
    FlowSpaces spaces;
    SparseMatrix divergence, turn, M, M_below, boundary;
    std::unique_ptr<SaddleSolver> solver;

    System(const Cells& on, const StokesOptions& options)
        : FlowUnits{on.unit()},
          cells((check_positive("the viscosity", options.viscosity), on)),
          n(cells.dimension()),
          viscosity(in_unit(Vector::Constant(1, options.viscosity), 2, "viscosity")[0]),
          spaces(cells, options.everywhere, options.facets),
          divergence(derivative(cells.complex(), n - 1)),
          turn(SparseMatrix(derivative(cells.complex(), n - 2).transpose()) *
               cells.stars()[n - 1].matrix()),
          M(cells.stars()[n - 1].matrix()),
          M_below(cells.stars()[n - 2].matrix()),
          boundary(dual_boundary_derivative(cells.complex(), 1)) {
        check_held_back(cells.complex(), spaces);
        check_positive_mass(spaces.vorticity.inside().stars()[n - 2], Side::primal, n - 2);
        check_flux_star();
        const SparseMatrix P = inclusion(spaces.flux.free(), cells.size(n - 1));
        const SparseMatrix Q = inclusion(spaces.vorticity.free(), cells.size(n - 2));
        const SparseMatrix& d = spaces.divergence;
        const SparseMatrix Q_transposed = Q.transpose();
        solver = std::make_unique<SaddleSolver>(
            SparseMatrix(viscosity * SparseMatrix(d.transpose()) * cells.stars()[n].matrix() * d),
            stacked(SparseMatrix(viscosity * Q_transposed * turn * P), d),
            padded(SparseMatrix(viscosity * Q_transposed * M_below * Q),
                   static_cast<Index>(d.rows())),
            options.linear_solver, n);
    }

    /// An open facet without dual has the pressure of its cell.
    void check_flux_star() const {
        CellMarks known = spaces.flux.fixed();
        const std::vector<bool> without_dual = cells.boundary_facets_without_dual();
        for (Index f = 0; f < cells.size(n - 1); ++f)
            known[n - 1][f] = known[n - 1][f] || without_dual[f];
        mark_faces(cells.complex(), known);
        const auto others = FormSpace::vanishing_on(cells, Side::primal, n - 1, known);
        check_positive_mass(others.inside().stars()[n - 1], Side::primal, n - 1);
    }

    /// The pressure at open facets, as the difference of pressures that facets see has it.
    Vector beyond(const Vector& pressure) const {
        Vector result = Vector::Zero(pressure.size());
        for (const auto& [f, cell, outward] : spaces.open)
            result[f] = outward * pressure[f];
        return result;
    }
};

StokesSolver::StokesSolver(const Cells& cells, const StokesOptions& options)
    : system_(std::make_shared<System>(cells, options)) {}

StokesFlow StokesSolver::solve(const Cochain& force, const StokesData& data) const {
    const System& of = *system_;
    const int n = of.n;
    check(of.cells.complex(), force);
    if (force.side != Side::primal || force.degree != n - 1)
        throw InvalidInput(
            fmt::format("the force is a {} {}-form: expected its flux, a primal {}-form",
                        name(force.side), force.degree, n - 1));
    const auto given = [&](const char* what, const Vector& values, int power, const auto& star) {
        return of.in_unit(or_zeros(what, values, star.rows()), power, what);
    };
    Vector flux = given("fluxes through facets", data.through, n, of.M);
    const Vector along = given("tangential velocities", data.along, 2, of.M_below);
    Vector vorticity = given("vorticities", data.vorticity, n - 2, of.M_below);
    const Vector pressure = given("pressures", data.pressure, 2, of.M);
    const FormSpace &fluxes = of.spaces.flux, &vorticities = of.spaces.vorticity;
    flux(fluxes.free()).setZero();
    vorticity(vorticities.free()).setZero();
    of.spaces.check_balance(flux);
    const double nu = of.viscosity;
    const Vector out = of.divergence * flux;
    const Vector b =
        of.M * of.in_unit(force.values, n, "forces") - of.beyond(pressure) -
        nu * (of.divergence.transpose() * out.cwiseQuotient(of.cells.stars().volumes().primal(n))) -
        nu * (of.turn.transpose() * vorticity);
    const double sign = n % 2 == 0 ? 1 : -1; // of star u in the derivative of degree n-2
    const Vector turned =
        -nu * (of.turn * flux - sign * (of.boundary * along) - of.M_below * vorticity);
    Vector g(vorticities.size() + out.size());
    g << vorticities.restrict(turned), -out;
    auto [u, c, report] = of.solver->solve(fluxes.restrict(b), g);

    flux(fluxes.free()) = u;
    vorticity(vorticities.free()) = c.head(vorticities.size());
    Vector found = -c.tail(out.size());
    of.spaces.loose.remove_means(found);
    return {{Side::primal, n - 1, of.in_input(flux, n, "fluxes")},
            {Side::primal, n - 2, of.in_input(vorticity, n - 2, "vorticities")},
            {Side::dual, 0, of.in_input(found, 2, "pressures")},
            std::move(report)};
}

} // namespace polydec
