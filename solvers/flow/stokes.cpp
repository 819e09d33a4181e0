// SPDX-License-Identifier: MIT
#include "solvers/flow/stokes.h"

#include "base/checks.h"
#include "base/errors.h"
#include "complex/components.h"
#include "complex/homology.h"
#include "complex/relative.h"
#include "dec/forms/boundary_conditions.h"
#include "dec/forms/derivative.h"
#include "dec/positive_mass.h"
#include "meshes/unit_of_length.h"
#include "solvers/sources/saddle_solver.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace polydec {

namespace {

void check_options(const CellComplex& complex, const HodgeStars& stars,
                   const StokesOptions& options) {
    check_fit(complex, stars);
    const int n = complex.dimension();
    check_number("the dimension of a flow", n, 2, 1000);
    if (!(options.viscosity > 0) || !std::isfinite(options.viscosity))
        throw InvalidInput(fmt::format("a viscosity of {} is given: expected a finite one above 0",
                                       options.viscosity));
    if (!options.facets.empty())
        check_as_many("conditions of facets", std::ssize(options.facets), complex.size(n - 1));
}

/// The facets of the boundary with their conditions, as closed sets of cells.
struct Walls {
    CellMarks closed;        // facets through which the flux is given
    CellMarks slipping;      // those where the vorticity is
    std::vector<Index> open; // those where the pressure is

    Walls(const CellComplex& complex, const StokesOptions& options) {
        const int n = complex.dimension();
        for (int k = 0; k <= n; ++k)
            for (CellMarks* marks : {&closed, &slipping})
                marks->emplace_back(complex.size(k), false);
        for (Index f = 0; f < complex.size(n - 1); ++f) {
            if (complex.coface_counts(n - 1)[f] != 1)
                continue;
            const auto kind = options.facets.empty() ? options.everywhere : options.facets[f];
            closed[n - 1][f] = kind != FlowBoundary::open;
            slipping[n - 1][f] = kind == FlowBoundary::free_slip;
            if (kind == FlowBoundary::open)
                open.push_back(f);
        }
        mark_faces(complex, closed);
        mark_faces(complex, slipping);
    }
};

/// Throws InvalidInput if there are flows without vorticity, divergence and pressure: those around
/// holes and between open facets, which a wall without slip holds back. The graph is that of
/// n-cells.
void check_held_back(const CellComplex& complex, const Walls& walls, const SparseMatrix& graph) {
    const int n = complex.dimension();
    const Index cells = complex.size(n);
    std::vector<bool> sticks(static_cast<std::size_t>(cells), false);
    for (Index t = 0; t < cells; ++t)
        for (const SignedFace& f : complex.incidences(n - 1)[t])
            if (walls.closed[n - 1][f.face] && !walls.slipping[n - 1][f.face])
                sticks[t] = true;
    const FreeComponents loose(graph, std::vector<bool>(sticks.size(), false), sticks,
                               Vector::Ones(cells));
    if (loose.count() == 0)
        return;
    CellMarks left_out = walls.closed;
    for (Index t = 0; t < cells; ++t)
        left_out[n][t] = loose.of(t) < 0;
    mark_faces(complex, left_out);
    const Index free = betti_numbers(relative_complex(complex, left_out).complex)[n - 1];
    if (free > 0)
        throw InvalidInput(fmt::format("{} flows around holes or between open facets are held back "
                                       "by nothing: expected a wall without slip",
                                       free));
}

std::vector<Index> other_cells(const std::vector<bool>& marks) {
    std::vector<Index> result;
    for (Index s = 0; s < std::ssize(marks); ++s)
        if (!marks[s])
            result.push_back(s);
    return result;
}

SparseMatrix columns_of(const std::vector<Index>& columns, Index size) {
    std::vector<Eigen::Triplet<double, Index>> entries;
    for (const Index column : columns)
        entries.emplace_back(column, static_cast<Index>(entries.size()), 1.0);
    SparseMatrix result(size, static_cast<Index>(columns.size()));
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
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
    check_as_many(what, values.size(), size);
    if (!values.allFinite())
        throw InvalidInput(fmt::format("{} on the boundary are not finite", what));
    return values;
}

} // namespace

/// Of u and (w, -p): nu d^T M_n d u + nu M d w - d^T p, which fixes the divergence twice, so that
/// the upper block is not empty; and the turn and the divergence of u.
struct StokesSolver::System {
    CellComplex complex;
    int n;
    double unit; // of lengths; of data and viscosity that of the input
    double viscosity;
    Walls walls;
    std::vector<Index> inside;   // facets of unknown flux
    std::vector<Index> swirling; // (n-2)-cells of unknown vorticity
    SparseMatrix divergence, turn, M, M_below, boundary;
    Vector volumes;
    FreeComponents free; // of the pressure
    std::unique_ptr<SaddleSolver> solver;

    System(const CellComplex& cells, const HodgeStars& stars, const StokesOptions& options,
           double length)
        : complex((check_options(cells, stars, options), cells)),
          n(cells.dimension()),
          unit(length),
          viscosity(in_unit(Vector::Constant(1, options.viscosity), 2, "viscosity")[0]),
          walls(cells, options),
          inside(other_cells(walls.closed[n - 1])),
          swirling(other_cells(walls.slipping[n - 2])),
          divergence(derivative(cells, n - 1)),
          turn(SparseMatrix(derivative(cells, n - 2).transpose()) * stars[n - 1].matrix()),
          M(stars[n - 1].matrix()),
          M_below(stars[n - 2].matrix()),
          boundary(dual_boundary_derivative(cells, 1)),
          volumes(stars.volumes().primal(n)) {
        check_held_back(complex, walls, divergence * SparseMatrix(divergence.transpose()));
        const auto star_without = [&](const CellMarks& marks, int k) {
            return relative_stars(relative_complex(complex, marks), stars)[k];
        };
        check_positive_mass(star_without(walls.slipping, n - 2), Side::primal, n - 2);
        // an open facet without dual has the pressure of its cell
        CellMarks known = walls.closed;
        for (const Index f : stars[n - 1].zeros())
            known[n - 1][f] = cells.coface_counts(n - 1)[f] == 1;
        mark_faces(cells, known);
        check_positive_mass(star_without(known, n - 1), Side::primal, n - 1);
        const SparseMatrix P = columns_of(inside, complex.size(n - 1));
        const SparseMatrix Q = columns_of(swirling, complex.size(n - 2));
        const SparseMatrix d = divergence * P, Q_transposed = Q.transpose();
        const SparseMatrix cells_of = divergence.transpose();
        std::vector<bool> tied(static_cast<std::size_t>(cells.size(n)), false);
        for (const Index f : walls.open)
            tied[SparseMatrix::InnerIterator(cells_of, f).col()] = true;
        free = FreeComponents(SparseMatrix(d * SparseMatrix(d.transpose())),
                              std::vector<bool>(tied.size(), false), tied, volumes);
        solver = std::make_unique<SaddleSolver>(
            SparseMatrix(viscosity * SparseMatrix(d.transpose()) * stars[n].matrix() * d),
            stacked(SparseMatrix(viscosity * Q_transposed * turn * P), d),
            padded(SparseMatrix(viscosity * Q_transposed * M_below * Q),
                   static_cast<Index>(d.rows())),
            options.linear_solver, n);
    }

    Vector in_unit(const Vector& values, int power, const char* what) const {
        return form_in_input_units(values, unit, -power, what);
    }
    Vector in_input(const Vector& values, int power, const char* what) const {
        return form_in_input_units(values, unit, power, what);
    }

    /// The pressure at open facets, as the difference of pressures that facets see has it.
    Vector beyond(const Vector& pressure) const {
        const SparseMatrix cells = divergence.transpose();
        Vector result = Vector::Zero(pressure.size());
        for (const Index f : walls.open)
            result[f] = SparseMatrix::InnerIterator(cells, f).value() * pressure[f];
        return result;
    }
};

StokesSolver::StokesSolver(const Cells& cells, const StokesOptions& options)
    : system_(std::make_unique<System>(cells.complex(), cells.stars(), options, cells.unit())) {}

StokesSolver::StokesSolver(StokesSolver&&) noexcept = default;
StokesSolver::~StokesSolver() = default;

StokesFlow StokesSolver::solve(const Cochain& force, const StokesData& data) const {
    const System& of = *system_;
    const int n = of.n;
    check(of.complex, force);
    if (force.side != Side::primal || force.degree != n - 1)
        throw InvalidInput(fmt::format("a {} {}-form is given as a force: expected its flux, a "
                                       "primal {}-form",
                                       name(force.side), force.degree, n - 1));
    const auto given = [&](const char* what, const Vector& values, int power, const auto& star) {
        return of.in_unit(or_zeros(what, values, star.rows()), power, what);
    };
    Vector flux = given("fluxes through facets", data.through, n, of.M);
    const Vector along = given("tangential velocities", data.along, 2, of.M_below);
    Vector vorticity = given("vorticities", data.vorticity, n - 2, of.M_below);
    const Vector pressure = given("pressures", data.pressure, 2, of.M);
    flux(of.inside).setZero();
    vorticity(of.swirling).setZero();
    const double nu = of.viscosity;
    Vector out = of.divergence * flux;
    constexpr double rounding = 1e-10;
    const double excess = of.free.balance(out).worst;
    if (excess > rounding)
        throw InvalidInput(fmt::format("of what flows through the boundary of a component {:.3g} "
                                       "more flows in or out: expected a balance, or an open facet",
                                       excess));
    const Vector b = of.M * of.in_unit(force.values, n, "forces") - of.beyond(pressure) -
                     nu * (of.divergence.transpose() * out.cwiseQuotient(of.volumes)) -
                     nu * (of.turn.transpose() * vorticity);
    const double sign = n % 2 == 0 ? 1 : -1; // of star u in the derivative of degree n-2
    const Vector turned =
        -nu * (of.turn * flux - sign * (of.boundary * along) - of.M_below * vorticity);
    Vector g(std::ssize(of.swirling) + out.size());
    g << turned(of.swirling), -out;
    auto [u, c, report] = of.solver->solve(b(of.inside), g);

    flux(of.inside) = u;
    vorticity(of.swirling) = c.head(std::ssize(of.swirling));
    Vector found = -c.tail(out.size());
    of.free.remove_means(found);
    return {{Side::primal, n - 1, of.in_input(flux, n, "fluxes")},
            {Side::primal, n - 2, of.in_input(vorticity, n - 2, "vorticities")},
            {Side::dual, 0, of.in_input(found, 2, "pressures")},
            std::move(report)};
}

} // namespace polydec
