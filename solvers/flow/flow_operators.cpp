// SPDX-License-Identifier: MIT
#include "solvers/flow/flow_operators.h"

#include "base/checks.h"
#include "base/errors.h"
#include "dec/discretization/positive_mass.h"
#include "dec/fields/cell_centers.h"
#include "solvers/time/largest_pair.h"

namespace polydec {

namespace {

void check_numbers(const char* what, const Vector& values, Index expected) {
    if (values.size() > 0)
        check_values(what, values, expected);
}

void check_options(const Discretization& mesh, const FlowOptions& options) {
    const int n = mesh.dimension();
    const Index facets = mesh.complex().size(n - 1);
    check_not_negative("the viscosity", options.viscosity);
    check_numbers("fluxes at the boundary", options.boundary_flux, facets);
    check_numbers("vorticities of the frame", options.rotation, mesh.complex().size(n - 2));
    if (options.wall_velocity.size() == 0)
        return;
    check_as_many("velocities of walls", options.wall_velocity.rows(), facets);
    check_as_many("components of velocities of walls", options.wall_velocity.cols(),
                  mesh.ambient_dimension());
    if (!options.wall_velocity.allFinite())
        throw InvalidInput("velocities of walls are not all finite: expected finite numbers");
}

/// Around each (n-2)-cell, the part of the circulation that is along the boundary, where the
/// velocity there is known: from the center of one facet to that of the cell, and on to the center
/// of the other.
Vector along_walls(const Discretization& mesh, const std::vector<BoundaryFacet>& dragged,
                   const Points& velocity) {
    const int n = mesh.dimension();
    Vector result = Vector::Zero(mesh.size(n - 2));
    if (velocity.size() == 0)
        return result;
    const Points facets = cell_centers(mesh, n - 1) / mesh.unit();
    const Points edges = cell_centers(mesh, n - 2) / mesh.unit();
    for (const auto& [f, cell, outward] : dragged)
        for (const auto& [e, sign] : mesh.complex().incidences(n - 2)[f])
            result[e] += outward * sign * velocity.row(f).dot(edges.row(e) - facets.row(f));
    return result;
}

/// Throws InvalidInput, like polydec::require_use, if data on the boundary apply nowhere.
void require_use(const FlowSpaces& spaces, const FlowOptions& options) {
    const auto facets = std::ssize(boundary_facets(spaces.flux.cells().complex()));
    require_facets(options.boundary_flux.size() > 0 ? "FlowOptions::boundary_flux" : "",
                   std::ssize(spaces.open) < facets, facets, "a facet that is not open");
    require_facets(options.wall_velocity.size() > 0 ? "FlowOptions::wall_velocity" : "",
                   !spaces.dragged.empty(), facets, "a no-slip facet");
}

Vector given_flux(const FormSpace& fluxes, const Vector& given) {
    const std::vector<bool>& fixed = fluxes.fixed()[fluxes.degree()];
    Vector result = Vector::Zero(std::ssize(fixed));
    for (Index f = 0; f < given.size(); ++f)
        if (fixed[f])
            result[f] = given[f];
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

} // namespace

FlowOperators::FlowOperators(const Discretization& on, const FlowOptions& how)
    : FlowUnits{on.unit()},
      mesh((check_options(on, how), on)),
      options(in_unit_of(on, how)),
      n(mesh.dimension()),
      spaces(mesh, how.everywhere, how.facets),
      star(Operator::star(mesh.stars()[n - 1])),
      curl(Operator::derivative(mesh.complex(), n - 2)),
      flux_star(spaces.flux.inside().stars()[n - 1]),
      vorticity_star(spaces.vorticity.inside().stars()[n - 2]),
      wall_circulation(along_walls(mesh, spaces.dragged, options.wall_velocity)),
      boundary_flux(given_flux(spaces.flux, options.boundary_flux)) {
    require_use(spaces, options);
    check_positive_mass(flux_star, Side::primal, n - 1);
    check_positive_mass(vorticity_star, Side::primal, n - 2);
    if (options.viscosity > 0)
        vorticity_star.require_diagonal();
    spaces.check_balance(boundary_flux);
}

Vector FlowOperators::free_circulation(const Vector& w, double along) const {
    return spaces.vorticity.restrict(
        Vector(curl.transposed() * (star * w) + along * wall_circulation));
}

Vector FlowOperators::vorticity(const Vector& w, double along) const {
    return spaces.vorticity.extend(Vector(vorticity_star.solve(free_circulation(w, along))));
}

double FlowOperators::friction_rate() const {
    const Index size = vorticity_star.size();
    if (options.viscosity == 0 || size == 0)
        return 0;
    const Vector scale = vorticity_star.inverse().cwiseSqrt(); // to unit mass
    const auto apply = [&](const Vector& x, Vector& y) {
        const Vector z = spaces.vorticity.extend(Vector(scale.cwiseProduct(x)));
        const Vector w = flux_star.solve(Vector(spaces.flux.restrict(curl_of(z))));
        y = scale.cwiseProduct(free_circulation(spaces.flux.extend(w), 0));
    };
    return options.viscosity * largest_pair({size, apply}).first;
}

} // namespace polydec
