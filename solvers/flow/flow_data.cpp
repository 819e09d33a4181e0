// SPDX-License-Identifier: MIT
#include "solvers/flow/flow_data.h"

#include "base/checks.h"
#include "base/errors.h"
#include "dec/boundary/boundary_conditions.h"
#include "dec/fields/lie_derivative.h"
#include "dec/forms/input_units.h"
#include "dec/forms/operator.h"
#include "dec/metric/simplex_geometry.h"
#include "solvers/sources/poisson.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace polydec {

std::vector<FlowBoundary> flow_boundary(const CellComplex& complex,
                                        const std::vector<FlowFacets>& chosen) {
    const Index facets = complex.size(complex.dimension() - 1);
    const std::vector<BoundaryFacet> boundary = boundary_facets(complex);
    std::vector<FlowBoundary> result(static_cast<std::size_t>(facets), FlowBoundary::free_slip);
    for (const auto& [kind, given, name] : chosen) {
        std::vector<bool> marks = given;
        if (marks.size() == 1)
            marks.assign(result.size(), given[0]);
        check_as_many("marks of facets", std::ssize(marks), facets);
        const bool is_used = std::any_of(boundary.begin(), boundary.end(),
                                         [&](const BoundaryFacet& on) { return marks[on.facet]; });
        require_facets(name, is_used, std::ssize(boundary), "a facet on the boundary");
        for (std::size_t f = 0; f < result.size(); ++f)
            if (marks[f])
                result[f] = kind;
    }
    return result;
}

Vector flow_of_vorticity(const Discretization& mesh, const Vector& vorticity) {
    if (mesh.dimension() != 2)
        throw InvalidInput(fmt::format("vorticities at vertices define no flow in dimension {}: "
                                       "expected a surface; give velocities instead",
                                       mesh.dimension()));
    const Vector psi = PoissonSolver({mesh, Side::primal, 0, {BoundaryCondition::essential}})
                           .solve({Side::primal, 0, vorticity})
                           .form.values;
    return Operator::derivative(mesh.complex(), 0) * psi;
}

Vector flow_of_velocity(const Discretization& mesh, const Points& velocity) {
    const int n = mesh.dimension();
    const Vector flux =
        interior_product(mesh, velocity, n, Sampling::centered) * mesh.volumes().primal(n);
    return form_in_input_units(flux, mesh.unit(), n,
                               "fluxes"); // of vectors in the unit of the mesh
}

Vector flux_through_boundary(const Discretization& mesh, const Points& velocity) {
    const int n = mesh.dimension();
    const auto& K = mesh.pieces();
    const auto [points, corners] = mesh.places();
    require_points(points.cols(), "a velocity at the boundary");
    if (!mesh.passage().is_identity())
        require_straight(K, mesh.measured_points(), "a velocity at the boundary");
    check_as_many("velocities at facets", velocity.rows(), mesh.complex().size(n - 1));
    check_as_many("components of velocities", velocity.cols(), points.cols());
    Vector flux = Vector::Zero(velocity.rows());
    for (Index t = 0; t < K.size(n); ++t)
        for (int i = 0; i <= n; ++i) {
            const Index side = K.face(n, t, i);
            if (K.coface_counts(n - 1)[side] != 1)
                continue;
            // the area of a facet, outwards, is the gradient of the opposite corner's coordinate
            // against it, times n times the volume
            const DenseMatrix gradients = barycentric_gradients(points, vertices(corners, t));
            const int outward = K.sign(n, t, i);
            const Index facet = mesh.merging().carriers(n - 1)[side].cell;
            const int piece = mesh.merging().diamond(n - 1).coeff(facet, side);
            flux[facet] -= outward * piece * n * mesh.geometry().volumes().primal(n)[t] *
                           gradients.row(i).dot(velocity.row(facet));
        }
    constexpr double rounding = 1e-13;
    const Vector& areas = mesh.volumes().primal(n - 1);
    for (Index f = 0; f < flux.size(); ++f)
        if (std::abs(flux[f]) <= rounding * areas[f] * velocity.row(f).norm())
            flux[f] = 0;
    return form_in_input_units(flux, mesh.unit(), n - 1, "fluxes");
}

} // namespace polydec
