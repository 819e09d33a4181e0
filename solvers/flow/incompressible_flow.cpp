// SPDX-License-Identifier: MIT
#include "solvers/flow/incompressible_flow.h"

#include "base/checks.h"
#include "dec/forms/derivative.h"
#include "solvers/flow/flow_operators.h"

#include <cmath>
#include <limits>

namespace polydec {

struct IncompressibleFlow::Parts {
    Advection advection;
    std::shared_ptr<const FlowOperators> operators;
    FlowProjection projection;

    Parts(const Discretization& mesh, const FlowOptions& options)
        : advection(mesh),
          operators(std::make_shared<FlowOperators>(mesh, options)),
          projection(operators, 0) {}

    void check(const Vector& w) const {
        check_as_many("fluxes", w.size(), operators->mesh.complex().size(operators->n - 1));
    }
};

IncompressibleFlow::IncompressibleFlow(const Discretization& mesh, const FlowOptions& options)
    : parts_(std::make_shared<Parts>(mesh, options)) {}

const Discretization& IncompressibleFlow::mesh() const {
    return parts_->operators->mesh;
}

const FlowOptions& IncompressibleFlow::options() const {
    return parts_->operators->options;
}

const Advection& IncompressibleFlow::advection() const {
    return parts_->advection;
}

Vector IncompressibleFlow::project(const Vector& flux) const {
    parts_->check(flux);
    return parts_->projection.solve(parts_->operators->star * flux).flux;
}

Vector IncompressibleFlow::vorticity(const Vector& w) const {
    parts_->check(w);
    const auto& flow = *parts_->operators;
    return flow.swirling.extend(flow.n - 2, flow.vorticity(w, 1));
}

Vector IncompressibleFlow::inertia(const Vector& w) const {
    Vector z = vorticity(w);
    if (options().rotation.size() > 0)
        z += options().rotation;
    return -parts_->advection(z, w);
}

Vector IncompressibleFlow::friction(const Vector& w) const {
    parts_->check(w);
    const auto& flow = *parts_->operators;
    if (flow.options.viscosity == 0)
        return Vector::Zero(w.size());
    return -flow.options.viscosity * flow.curl_of(flow.vorticity(w, 1));
}

Vector IncompressibleFlow::rate(const Vector& w) const {
    return parts_->projection.solve_at_rest(inertia(w) + friction(w)).flux;
}

Vector IncompressibleFlow::momentum(const Vector& w) const {
    parts_->check(w);
    return parts_->operators->star * w;
}

Cochain IncompressibleFlow::pressure(const Vector& w) const {
    const auto& flow = *parts_->operators;
    const Vector total = -parts_->projection.solve_at_rest(inertia(w) + friction(w)).multiplier;
    Vector p = total - parts_->advection.kinetic_energy(w);
    bool open = false;
    for (const bool tied : flow.tied)
        open = open || tied;
    const Vector& volumes = flow.mesh.volumes().primal(flow.n);
    if (!open)
        p.array() -= volumes.dot(p) / volumes.sum();
    return {Side::dual, 0, std::move(p)};
}

double IncompressibleFlow::energy(const Vector& w) const {
    parts_->check(w);
    return w.dot(parts_->operators->star * w) / 2;
}

double IncompressibleFlow::dissipation(const Vector& w) const {
    parts_->check(w);
    const auto& flow = *parts_->operators;
    const Vector z = flow.vorticity(w, 1);
    return flow.options.viscosity * z.dot(flow.vorticity_star * z);
}

Vector IncompressibleFlow::circulations(const Vector& w) const {
    parts_->check(w);
    const auto& flow = *parts_->operators;
    return Operator::derivative(flow.mesh.complex(), flow.n - 2).transposed() * (flow.star * w);
}

double IncompressibleFlow::divergence(const Vector& w) const {
    parts_->check(w);
    const auto& flow = *parts_->operators;
    const SparseMatrix d = polydec::derivative(flow.mesh.complex(), flow.n - 1);
    const double size = (d.cwiseAbs() * w.cwiseAbs()).maxCoeff();
    return size > 0 ? (d * w).cwiseAbs().maxCoeff() / size : 0;
}

double IncompressibleFlow::exchange_time(const Vector& w) const {
    const double rate = parts_->advection.exchange_rate(w);
    return rate > 0 ? 1 / rate : std::numeric_limits<double>::infinity();
}

FlowProjection IncompressibleFlow::implicit_part(double theta) const {
    return {parts_->operators, theta};
}

} // namespace polydec
