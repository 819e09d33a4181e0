// SPDX-License-Identifier: MIT
#include "solvers/flow/incompressible_flow.h"

#include "base/checks.h"
#include "base/errors.h"
#include "base/exponent.h"
#include "dec/forms/cochain.h"
#include "solvers/flow/flow_operators.h"

#include <cmath>
#include <limits>

namespace polydec {

struct IncompressibleFlow::Parts {
    FlowOptions options; // as they were given
    Advection advection;
    std::shared_ptr<const FlowOperators> operators;
    FlowProjection projection;

    Parts(const Discretization& mesh, const FlowOptions& given)
        : options(given),
          advection(mesh),
          operators(std::make_shared<FlowOperators>(mesh, given)),
          projection(operators, 0) {}

    /// Fluxes in the unit of the mesh.
    Vector fluxes(const Vector& w) const {
        check_values("fluxes", w, operators->mesh.complex().size(operators->n - 1));
        return operators->in_unit(w, operators->n, "fluxes");
    }

    /// In the unit of the mesh.
    template <class Star>
    static ScaledNumber squared(const Vector& values, const Star& star) {
        return square(values, [&](const Vector& x) { return star * x; });
    }
    ScaledNumber squared(const Vector& w) const { return squared(fluxes(w), operators->star); }

    /// Half a square, in the units of the input.
    double half(const ScaledNumber& square, int power, const char* what) const {
        return ScaledNumber{square.part / 2,
                            square.exponent + power * std::ilogb(operators->mesh.unit())}
            .in_range(what);
    }
};

IncompressibleFlow::IncompressibleFlow(const Discretization& mesh, const FlowOptions& options)
    : parts_(std::make_shared<Parts>(mesh, options)) {}

const Discretization& IncompressibleFlow::mesh() const& {
    return parts_->operators->mesh;
}

const FlowOptions& IncompressibleFlow::options() const& {
    return parts_->options;
}

Vector IncompressibleFlow::project(const Vector& flux) const {
    constexpr double rounding = 1e-11;
    const Vector found = parts_->projection.solve(momentum(flux)).flux;
    const bool is_rounding =
        !flux.isZero(0) && ratio_of_energies(found, flux) <= rounding * rounding;
    return is_rounding ? parts_->projection.solve(Vector::Zero(flux.size())).flux : found;
}

Vector IncompressibleFlow::vorticity(const Vector& w) const {
    const auto& flow = *parts_->operators;
    return flow.in_input(flow.vorticity(parts_->fluxes(w), 1), flow.n - 2, "vorticities");
}

Vector IncompressibleFlow::inertia(const Vector& w) const {
    Vector z = vorticity(w);
    if (options().rotation.size() > 0)
        z += options().rotation;
    return -parts_->advection(z, w);
}

Vector IncompressibleFlow::friction(const Vector& w) const {
    const Vector flux = parts_->fluxes(w);
    const auto& flow = *parts_->operators;
    if (flow.options.viscosity == 0)
        return Vector::Zero(w.size());
    return flow.in_input(-flow.options.viscosity * flow.curl_of(flow.vorticity(flux, 1)), 2,
                         "forces");
}

Vector IncompressibleFlow::rate(const Vector& w) const {
    return parts_->projection.solve_at_rest(inertia(w) + friction(w)).flux;
}

Vector IncompressibleFlow::momentum(const Vector& w) const {
    return parts_->operators->in_input(parts_->operators->star * parts_->fluxes(w), 2, "momenta");
}

Cochain IncompressibleFlow::pressure(const Vector& w) const {
    const auto& flow = *parts_->operators;
    const Vector c = parts_->projection.solve_at_rest(inertia(w) + friction(w)).multiplier;
    const Vector total = -flow.in_input(c, 2, "pressures");
    Vector p = total - parts_->advection.kinetic_energy(w);
    const Vector& volumes = flow.mesh.volumes().primal(flow.n);
    if (flow.spaces.open.empty())
        p.array() -= volumes.dot(p) / volumes.sum();
    return {Side::dual, 0, std::move(p)};
}

double IncompressibleFlow::energy(const Vector& w) const {
    return parts_->half(parts_->squared(w), parts_->operators->n + 2, "the energy of a flow");
}

double IncompressibleFlow::relative_energy(const Vector& w, const Vector& other) const {
    if (w.isZero(0) && other.isZero(0))
        return 1;
    const double ratio = ratio_of_energies(w, other);
    if (!std::isfinite(ratio))
        throw InvalidInput("the ratio of the energies of two flows is not finite: the second flow "
                           "is at rest, or the first is too fast");
    return ratio;
}

double IncompressibleFlow::ratio_of_energies(const Vector& w, const Vector& other) const {
    return ratio(parts_->squared(w), parts_->squared(other));
}

double IncompressibleFlow::friction_rate() const {
    return parts_->operators->friction_rate();
}

double IncompressibleFlow::enstrophy(const Vector& w) const {
    const auto& flow = *parts_->operators;
    const Vector z = flow.spaces.vorticity.restrict(flow.vorticity(parts_->fluxes(w), 1));
    return parts_->half(Parts::squared(z, flow.vorticity_star), flow.n, "the enstrophy of a flow");
}

double IncompressibleFlow::dissipation(const Vector& w) const {
    return 2 * options().viscosity * enstrophy(w);
}

Vector IncompressibleFlow::circulations(const Vector& w) const {
    const auto& flow = *parts_->operators;
    return flow.in_input(flow.circulation(parts_->fluxes(w), 1), 2, "circulations");
}

double IncompressibleFlow::divergence(const Vector& w) const {
    const Vector flux = parts_->fluxes(w);
    const auto& flow = *parts_->operators;
    const SparseMatrix d = polydec::derivative(flow.mesh.complex(), flow.n - 1);
    const double size = (d.cwiseAbs() * flux.cwiseAbs()).maxCoeff();
    return size > 0 ? (d * flux).cwiseAbs().maxCoeff() / size : 0;
}

std::vector<std::string> warning_of_rest(const Vector& given, const Vector& flow) {
    if (given.isZero(0) || !flow.isZero(0))
        return {};
    return {
        "nothing of the given velocity or vorticity is that of a flow without divergence "
        "between these walls (vorticity counts inside alone, and on closed surfaces without its "
        "mean), so the fluid is at rest: to let it pass the boundary, give "
        "FlowOptions::boundary_flux, or open facets (FlowBoundary::open)"};
}

double IncompressibleFlow::exchange_time(const Vector& w) const {
    const double rate = parts_->advection.exchange_rate(w);
    return rate > 0 ? 1 / rate : std::numeric_limits<double>::infinity();
}

FlowProjection IncompressibleFlow::implicit_part(double theta) const {
    return {parts_->operators, theta};
}

} // namespace polydec
