// SPDX-License-Identifier: MIT
#include "python/bindings/convert.h"
#include "python/bindings/guarded.h"
#include "solvers/flow/advection.h"
#include "solvers/flow/flow_data.h"
#include "solvers/flow/incompressible_flow.h"
#include "solvers/flow/shallow_water.h"
#include "solvers/flow/stokes.h"

#include <array>

namespace polydec::python {

namespace {

/// The conditions of facets; one `false` is not given.
std::vector<FlowBoundary> conditions(const CellComplex& complex, std::vector<FlowFacets> chosen) {
    std::erase_if(chosen, [](const auto& each) { return each.marks == std::vector{false}; });
    return flow_boundary(complex, chosen);
}

void add_flow(py::module_& module) {
    using Flow = Guarded<IncompressibleFlow>;
    py::class_<Flow> flow(module, "IncompressibleFlow");
    flow.def(
        py::init([](const Discretization& mesh, double viscosity, const std::vector<bool>& no_slip,
                    const std::vector<bool>& open, Vector boundary_flux, Points wall_velocity,
                    Vector rotation, const std::string& engine) {
            const FlowOptions options{
                .viscosity = viscosity,
                .facets = conditions(mesh.complex(), {{FlowBoundary::no_slip, no_slip, "no_slip"},
                                                      {FlowBoundary::open, open, "open"}}),
                .boundary_flux = std::move(boundary_flux),
                .wall_velocity = std::move(wall_velocity),
                .rotation = std::move(rotation),
                .linear_solver = engine};
            return guarded<IncompressibleFlow>(mesh, options);
        }));
    const auto add = [&](const char* name, auto member) {
        flow.def(name, [member](Flow& self, const Vector& w) {
            return self.use([&](const IncompressibleFlow& of) { return (of.*member)(w); });
        });
    };
    flow.def("project", [](Flow& self, const Vector& flux) {
        Vector found = self.use([&](const IncompressibleFlow& of) { return of.project(flux); });
        warn(warning_of_rest(flux, found));
        return found;
    });
    add("vorticity", &IncompressibleFlow::vorticity);
    add("inertia", &IncompressibleFlow::inertia);
    add("friction", &IncompressibleFlow::friction);
    add("rate", &IncompressibleFlow::rate);
    add("momentum", &IncompressibleFlow::momentum);
    add("circulations", &IncompressibleFlow::circulations);
    add("energy", &IncompressibleFlow::energy);
    add("dissipation", &IncompressibleFlow::dissipation);
    add("divergence", &IncompressibleFlow::divergence);
    add("exchange_time", &IncompressibleFlow::exchange_time);
    flow.def("pressure", [](Flow& self, const Vector& w) {
        return self.use([&](const IncompressibleFlow& of) { return of.pressure(w).values; });
    });
}

void add_flux_transport(py::module_& module) {
    py::class_<FluxTransport>(module, "FluxTransport")
        .def(py::init<const Cells&, Sampling>())
        .def("mass_flux", &FluxTransport::mass_flux)
        .def("rate", &FluxTransport::rate)
        .def("stable_step", &FluxTransport::stable_step)
        .def("mass", &FluxTransport::mass)
        .def("outflow", &FluxTransport::outflow);
}

using Water = ShallowWater::State;

std::pair<Vector, Vector> parts_of(Water state) {
    return {std::move(state.depth), std::move(state.flux)};
}

void add_shallow_water(py::module_& module) {
    using Flow = Guarded<ShallowWater>;
    py::class_<Flow> flow(module, "ShallowWater");
    flow.def(py::init([](const Discretization& mesh, double gravity, Vector rotation,
                         Vector bottom) {
            return guarded<ShallowWater>(
                mesh, ShallowWaterOptions{gravity, std::move(rotation), std::move(bottom)});
        }))
        .def("rate",
             [](Flow& self, Vector depth, Vector flux) {
                 const Water now{std::move(depth), std::move(flux)};
                 return parts_of(self.use([&](const ShallowWater& of) { return of.rate(now); }));
             })
        .def("reaction", [](Flow& self, double time, Vector depth, Vector flux) {
            const std::vector<Cochain> forms{{Side::dual, 0, std::move(depth)},
                                             {Side::primal, 1, std::move(flux)}};
            auto rates = self.use([&](const ShallowWater& of) { return of(time, forms); });
            return parts_of({std::move(rates[0]), std::move(rates[1])});
        });
    const auto add = [&](const char* name, auto member) {
        flow.def(name, [member](Flow& self, Vector depth, Vector flux) {
            const Water now{std::move(depth), std::move(flux)};
            return self.use([&](const ShallowWater& of) { return (of.*member)(now); });
        });
    };
    add("mass", &ShallowWater::mass);
    add("energy", &ShallowWater::energy);
    add("potential_vorticity", &ShallowWater::potential_vorticity);
    add("potential_enstrophy", &ShallowWater::potential_enstrophy);
    add("stable_step", &ShallowWater::stable_step);
}

void add_stokes(py::module_& module) {
    using Solver = Guarded<StokesSolver>;
    py::class_<Solver>(module, "StokesSolver")
        .def(py::init([](const Cells& of, double viscosity, const std::vector<bool>& no_slip,
                         const std::vector<bool>& known, const std::string& engine) {
            const StokesOptions options{
                .viscosity = viscosity,
                .facets =
                    conditions(of.complex(), {{FlowBoundary::no_slip, no_slip, "no_slip"},
                                              {FlowBoundary::pressure, known, "pressure_on"}}),
                .linear_solver = engine};
            return guarded<StokesSolver>(of, options);
        }))
        .def("solve", [](Solver& self, const Cochain& force, const std::array<Vector, 4>& known) {
            const auto& [through, along, vorticity, pressure] = known;
            const StokesData data{through, along, vorticity, pressure};
            StokesFlow found =
                self.use([&](const StokesSolver& solver) { return solver.solve(force, data); });
            return py::make_tuple(std::move(found.flux), std::move(found.vorticity),
                                  std::move(found.pressure), report_of(found.report));
        });
}

} // namespace

void add_flows(py::module_& module) {
    module.def("flow_of_vorticity", [](const Discretization& mesh, const Vector& vorticity) {
        Vector fluxes = unlocked([&] { return flow_of_vorticity(mesh, vorticity); });
        warn(warning_of_rest(vorticity, fluxes));
        return fluxes;
    });
    module.def("flow_of_velocity", [](const Discretization& mesh, const Points& velocity) {
        Vector fluxes = unlocked([&] { return flow_of_velocity(mesh, velocity); });
        warn(warning_of_rest(velocity.reshaped(), fluxes));
        return fluxes;
    });
    module.def("flux_through_boundary", &flux_through_boundary, Unlocking());
    add_flow(module);
    add_shallow_water(module);
    add_flux_transport(module);
    add_stokes(module);
}

} // namespace polydec::python
