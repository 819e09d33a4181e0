// SPDX-License-Identifier: MIT
#include "solvers/flow/shallow_water.h"

#include "base/checks.h"
#include "base/errors.h"
#include "dec/discretization/positive_mass.h"
#include "dec/forms/cochain.h"
#include "solvers/flow/advection.h"
#include "solvers/flow/flow_spaces.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <utility>

namespace polydec {

namespace {

/// The mean of the values in cells around each vertex, each cell sharing its area among its
/// corners.
SparseMatrix means_at_vertices(const Discretization& mesh) {
    const auto& complex = mesh.complex();
    const SparseMatrix corners =
        derivative(complex, 1).cwiseAbs() * derivative(complex, 0).cwiseAbs();
    std::vector<Eigen::Triplet<double, Index>> shares;
    Vector sums = Vector::Zero(complex.size(0));
    for (Index cell = 0; cell < complex.size(2); ++cell) {
        double count = 0;
        for (SparseMatrix::InnerIterator corner(corners, cell); corner; ++corner)
            ++count;
        for (SparseMatrix::InnerIterator corner(corners, cell); corner; ++corner) {
            const double share = mesh.volumes().primal(2)[cell] / count;
            shares.emplace_back(static_cast<Index>(corner.col()), cell, share);
            sums[corner.col()] += share;
        }
    }
    SparseMatrix result(complex.size(0), complex.size(2));
    result.setFromTriplets(shares.begin(), shares.end());
    return sums.cwiseInverse().asDiagonal() * result;
}

} // namespace

/// In the unit of the mesh, but for depths, whose unit is their own.
struct ShallowWater::Parts : FlowUnits {
    ShallowWaterOptions options;
    Advection advection;
    Vector areas, star, vertex_areas;
    std::vector<bool> wall; // edges on the boundary
    SparseMatrix curl, divergence, sides, at_vertices;

    Parts(const Discretization& mesh, const ShallowWaterOptions& how)
        : FlowUnits{mesh.unit()},
          options(how),
          advection(mesh),
          areas(mesh.volumes().primal(2)),
          vertex_areas(mesh.stars()[0].diagonal()),
          curl(derivative(mesh.complex(), 0).transpose()),
          divergence(derivative(mesh.complex(), 1)),
          sides(divergence.cwiseAbs().transpose()),
          at_vertices(means_at_vertices(mesh)) {
        const FormSpace inside(mesh, Side::primal, 1, BoundaryCondition::essential);
        const HodgeStar inner = inside.inside().stars()[1];
        inner.require_diagonal();
        check_positive_mass(inner, Side::primal, 1);
        check_positive_mass(mesh.stars()[0], Side::primal, 0);
        star = inside.extend(Vector(inner.diagonal()));
        wall.assign(star.size(), false);
        for (const BoundaryFacet& on : boundary_facets(mesh.complex()))
            wall[on.facet] = true;
        if (options.rotation.size() == 0)
            options.rotation = Vector::Zero(vertex_areas.size());
        if (options.bottom.size() == 0)
            options.bottom = Vector::Zero(areas.size());
        check_values("vorticities of the frame", options.rotation, vertex_areas.size());
        check_values("heights of the bottom", options.bottom, areas.size());
        check_positive("gravity", options.gravity);
        options.gravity = in_unit(Vector::Constant(1, options.gravity), 2, "gravity")[0];
    }

    using FlowUnits::in_input;
    double in_input(double value, int power, const char* what) const {
        return in_input(Vector(Vector::Constant(1, value)), power, what)[0];
    }

    /// The fluxes, of a state that is one.
    Vector flux(const State& state) const {
        check_as_many("depths", state.depth.size(), areas.size());
        check_values("fluxes", state.flux, star.size());
        for (Index cell = 0; cell < areas.size(); ++cell)
            if (!(state.depth[cell] > 0) || !std::isfinite(state.depth[cell]))
                throw InvalidInput(
                    fmt::format("the depth of shallow water in cell {} is {}: expected a number "
                                "above 0; use shorter steps or more water",
                                cell, state.depth[cell]),
                    {.degree = 2, .cells = {cell}});
        return in_unit(state.flux, 2, "fluxes");
    }

    /// The mean depth at each edge: of the cells on both sides.
    Vector depth_at_edges(const Vector& depth) const { return sides * depth / 2; }

    Vector potential_vorticity(const State& state) const {
        const Vector circulation = curl * star.cwiseProduct(flux(state));
        return (options.rotation + circulation.cwiseQuotient(vertex_areas))
            .cwiseQuotient(at_vertices * state.depth);
    }
};

ShallowWater::ShallowWater(const Discretization& mesh, const ShallowWaterOptions& options) {
    if (mesh.dimension() != 2)
        throw InvalidInput(fmt::format(
            "shallow water is not defined in dimension {}: expected a surface", mesh.dimension()));
    parts_ = std::make_shared<Parts>(mesh, options);
}

ShallowWater::State ShallowWater::rate(const State& state) const {
    const Parts& parts = *parts_;
    const Vector flux = parts.flux(state);
    const Vector carried = parts.depth_at_edges(state.depth).cwiseProduct(flux);
    const Vector twice_energy = parts.star.cwiseProduct(flux).cwiseProduct(flux);
    const Vector head = (parts.sides.transpose() * twice_energy).cwiseQuotient(parts.areas) / 4 +
                        parts.options.gravity * (state.depth + parts.options.bottom);
    const Vector turned = parts.advection(parts.potential_vorticity(state),
                                          parts.in_input(carried, 2, "fluxes of mass"));
    const Vector along =
        parts.divergence.transpose() * head - parts.in_unit(turned, 2, "forces on fluxes");
    State result{-(parts.divergence * carried).cwiseQuotient(parts.areas), Vector(along.size())};
    for (Index e = 0; e < along.size(); ++e)
        result.flux[e] = parts.wall[e] ? 0 : along[e] / parts.star[e];
    result.flux = parts.in_input(result.flux, 2, "rates of fluxes");
    return result;
}

std::vector<Vector> ShallowWater::operator()(double, const std::vector<Cochain>& forms) const {
    check_as_many("forms of shallow water", std::ssize(forms), 2);
    const State state{forms[0].values, forms[1].values};
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    if (!(state.depth.array() > 0).all())
        return {Vector::Constant(state.depth.size(), none), Vector::Zero(state.flux.size())};
    State change = rate(state);
    return {std::move(change.depth), std::move(change.flux)};
}

double ShallowWater::stable_step(const State& state) const {
    const Parts& parts = *parts_;
    parts.flux(state);
    // waves have squared frequencies up to the row sums of div g h star^-1 grad
    const Vector depth = parts.depth_at_edges(state.depth);
    Vector conductances = Vector::Zero(depth.size());
    for (Index e = 0; e < depth.size(); ++e)
        if (!parts.wall[e])
            conductances[e] = parts.options.gravity * depth[e] / parts.star[e];
    const Vector squares = 2 * (parts.sides.transpose() * conductances).cwiseQuotient(parts.areas);
    return 1 / (std::sqrt(squares.maxCoeff()) / 2 + parts.advection.exchange_rate(state.flux));
}

double ShallowWater::mass(const State& state) const {
    parts_->flux(state);
    return parts_->in_input(parts_->areas.dot(state.depth), 2, "the mass");
}

double ShallowWater::energy(const State& state) const {
    const Parts& parts = *parts_;
    const Vector flux = parts.flux(state);
    const Vector kinetic = parts.star.cwiseProduct(flux).cwiseProduct(flux);
    const Vector surface = state.depth + parts.options.bottom;
    const double twice = parts.depth_at_edges(state.depth).dot(kinetic) +
                         parts.options.gravity * parts.areas.dot(surface.cwiseProduct(surface));
    return parts.in_input(twice / 2, 4, "the energy");
}

Vector ShallowWater::potential_vorticity(const State& state) const {
    return parts_->potential_vorticity(state);
}

double ShallowWater::potential_enstrophy(const State& state) const {
    const Vector q = potential_vorticity(state);
    const Vector depth = parts_->at_vertices * state.depth;
    const double twice = parts_->vertex_areas.dot(depth.cwiseProduct(q).cwiseProduct(q));
    return parts_->in_input(twice / 2, 2, "the potential enstrophy");
}

} // namespace polydec
