// SPDX-License-Identifier: MIT
#include "solvers/flow/flow_operators.h"

#include "base/checks.h"
#include "base/errors.h"
#include "dec/fields/cell_centers.h"
#include "dec/forms/boundary_conditions.h"
#include "dec/forms/derivative.h"
#include "dec/positive_mass.h"

#include <fmt/format.h>

#include <cmath>

namespace polydec {

namespace {

FlowBoundary kind_at(const FlowOptions& options, Index facet) {
    return options.facets.empty() ? options.everywhere : options.facets[facet];
}

void check_numbers(const char* what, const Vector& values, Index expected) {
    if (values.size() == 0)
        return;
    check_as_many(what, values.size(), expected);
    if (!values.allFinite())
        throw InvalidInput(fmt::format("{} of a flow are not finite: expected numbers", what));
}

void check_options(const Discretization& mesh, const FlowOptions& options) {
    const int n = mesh.dimension();
    const Index facets = mesh.complex().size(n - 1);
    if (!(options.viscosity >= 0) || !std::isfinite(options.viscosity))
        throw InvalidInput(fmt::format("a viscosity of {} is given: expected a finite one of 0 or "
                                       "more",
                                       options.viscosity));
    if (!options.facets.empty())
        check_as_many("conditions of facets", static_cast<Index>(options.facets.size()), facets);
    check_numbers("fluxes at the boundary", options.boundary_flux, facets);
    check_numbers("vorticities of the frame", options.rotation, mesh.complex().size(n - 2));
    if (options.wall_velocity.size() == 0)
        return;
    check_as_many("velocities of walls", options.wall_velocity.rows(), facets);
    check_as_many("components of velocities of walls", options.wall_velocity.cols(),
                  mesh.ambient_dimension());
    if (!options.wall_velocity.allFinite())
        throw InvalidInput("velocities of walls are not finite: expected numbers");
}

/// The boundary facets whose flux is given, with their faces; the (n-2)-cells of the boundary that
/// lie on no wall without slip, with theirs.
struct Marks {
    CellMarks given, still;

    Marks(const CellComplex& complex, const FlowOptions& options) {
        const int n = complex.dimension();
        for (int k = 0; k <= n; ++k)
            for (CellMarks* marks : {&given, &still})
                marks->emplace_back(complex.size(k), false);
        CellMarks sticking = given;
        const auto& cofaces = complex.coface_counts(n - 1);
        for (Index f = 0; f < complex.size(n - 1); ++f)
            if (cofaces[f] == 1) {
                const auto kind = kind_at(options, f);
                given[n - 1][f] = kind != FlowBoundary::open;
                for (const auto& [e, sign] : complex.incidences(n - 2)[f]) {
                    still[n - 2][e] = true;
                    if (kind == FlowBoundary::no_slip)
                        sticking[n - 2][e] = true;
                }
            }
        for (Index e = 0; e < complex.size(n - 2); ++e)
            still[n - 2][e] = still[n - 2][e] && !sticking[n - 2][e];
        mark_faces(complex, given);
        mark_faces(complex, still);
    }
};

/// Around each (n-2)-cell, the part of the circulation that is along walls: from the center of one
/// facet to that of the cell, and on to the center of the other.
Vector along_walls(const Discretization& mesh, const FlowOptions& options) {
    const int n = mesh.dimension();
    const CellComplex& complex = mesh.complex();
    Vector result = Vector::Zero(complex.size(n - 2));
    if (options.wall_velocity.size() == 0)
        return result;
    const Points facets = cell_centers(mesh, n - 1) / mesh.unit();
    const Points edges = cell_centers(mesh, n - 2) / mesh.unit();
    const SparseMatrix cells = derivative(complex, n - 1).transpose();
    const auto& cofaces = complex.coface_counts(n - 1);
    for (Index f = 0; f < complex.size(n - 1); ++f)
        if (cofaces[f] == 1 && kind_at(options, f) == FlowBoundary::no_slip) {
            const double outward = SparseMatrix::InnerIterator(cells, f).value();
            for (const auto& [e, sign] : complex.incidences(n - 2)[f])
                result[e] +=
                    outward * sign * options.wall_velocity.row(f).dot(edges.row(e) - facets.row(f));
        }
    return result;
}

/// Throws InvalidInput where more is to flow in than out and nothing is open.
void check_balance(const CellComplex& complex, const Vector& flux, const std::vector<bool>& tied) {
    const int n = complex.dimension();
    const Components parts = components(complex);
    Vector sums = Vector::Zero(parts.count), sizes = sums;
    std::vector<bool> open(static_cast<std::size_t>(parts.count), false);
    const Vector excess = derivative(complex, n - 1) * flux;
    const Vector through = derivative(complex, n - 1).cwiseAbs() * flux.cwiseAbs();
    for (Index cell = 0; cell < excess.size(); ++cell) {
        Index corner = cell;
        for (int k = n; k > 0; --k)
            corner = complex.incidences(k - 1)[corner][0].face;
        const Index part = parts.of_vertex[corner];
        sums[part] += excess[cell];
        sizes[part] += through[cell];
        open[part] = open[part] || tied[cell];
    }
    constexpr double rounding = 1e-8;
    for (Index part = 0; part < parts.count; ++part)
        if (!open[part] && std::abs(sums[part]) > rounding * sizes[part])
            throw InvalidInput(fmt::format("through the boundary {:.6g} more flows out than in, of "
                                           "{:.6g}: expected a balance, or an open boundary",
                                           sums[part], sizes[part]));
}

Vector given_flux(const CellComplex& complex, const FlowOptions& options, const CellMarks& given) {
    Vector result = Vector::Zero(complex.size(complex.dimension() - 1));
    for (Index f = 0; f < result.size() && options.boundary_flux.size() > 0; ++f)
        if (given[complex.dimension() - 1][f])
            result[f] = options.boundary_flux[f];
    return result;
}

FlowOptions in_unit_of(const Discretization& mesh, FlowOptions options) {
    const double unit = mesh.unit();
    const int n = mesh.dimension();
    options.viscosity =
        in_input_units(Vector::Constant(1, options.viscosity), unit, -2, "viscosity")[0];
    options.boundary_flux = in_input_units(options.boundary_flux, unit, -n, "boundary fluxes");
    options.wall_velocity =
        in_input_units(std::move(options.wall_velocity), unit, -1, "velocities of walls");
    options.rotation = in_input_units(options.rotation, unit, 2 - n, "vorticities of the frame");
    return options;
}

RelativeComplex without(const CellComplex& complex, const CellMarks& marks) {
    return relative_complex(complex, marks);
}

} // namespace

FlowOperators::FlowOperators(const Discretization& on, const FlowOptions& how)
    : mesh((check_options(on, how), on)),
      options(in_unit_of(on, how)),
      n(mesh.dimension()),
      star(Operator::star(mesh.stars()[n - 1])),
      swirling(without(mesh.complex(), Marks(mesh.complex(), options).still)),
      vorticity_star(relative_stars(swirling, mesh.stars())[n - 2]),
      curl(Operator::derivative(swirling.complex, n - 2)),
      wall_circulation(swirling.restrict(n - 2, along_walls(mesh, options))),
      unknown_star(mesh.stars()[n - 1]) {
    const Marks marks(mesh.complex(), options);
    const RelativeComplex inside = without(mesh.complex(), marks.given);
    unknown = inside.cells[n - 1];
    unknown_star = relative_stars(inside, mesh.stars())[n - 1];
    divergence = derivative(inside.complex, n - 1);
    check_positive_mass(unknown_star, Side::primal, n - 1);
    check_positive_mass(vorticity_star, Side::primal, n - 2);
    if (options.viscosity > 0)
        vorticity_star.require_diagonal();
    boundary_flux = given_flux(mesh.complex(), options, marks.given);
    tied.assign(static_cast<std::size_t>(mesh.complex().size(n)), false);
    const SparseMatrix cells = derivative(mesh.complex(), n - 1).transpose();
    for (const Index f : unknown)
        if (mesh.complex().coface_counts(n - 1)[f] == 1)
            tied[SparseMatrix::InnerIterator(cells, f).col()] = true;
    check_balance(mesh.complex(), boundary_flux, tied);
}

Vector FlowOperators::vorticity(const Vector& w, double along) const {
    return vorticity_star.solve(curl.transposed() * (star * w) + along * wall_circulation);
}

} // namespace polydec
