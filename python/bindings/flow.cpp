// SPDX-License-Identifier: MIT
#include "python/bindings/calculus.h"
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

/// Free slip at all facets but those marked; one mark may stand for all of them.
std::vector<FlowBoundary> boundary_of(const std::vector<bool>& no_slip,
                                      const std::vector<bool>& others, FlowBoundary kind,
                                      Index facets) {
    const auto holds = [](const std::vector<bool>& marks, Index i) {
        return marks[marks.size() == 1 ? 0 : i];
    };
    std::vector<FlowBoundary> result(facets, FlowBoundary::free_slip);
    for (Index i = 0; i < facets; ++i)
        if (holds(others, i))
            result[i] = kind;
        else if (holds(no_slip, i))
            result[i] = FlowBoundary::no_slip;
    return result;
}

using FlowMap = Vector (IncompressibleFlow::*)(const Vector&) const;
using FlowNumber = double (IncompressibleFlow::*)(const Vector&) const;

void add_flow(py::module_& module) {
    using Flow = Guarded<IncompressibleFlow>;
    py::class_<Flow> flow(module, "IncompressibleFlow");
    flow.def(py::init([](const Discretization& mesh, double viscosity,
                         const std::vector<bool>& no_slip, const std::vector<bool>& open,
                         const Numbers& boundary_flux, const Numbers& wall_velocity,
                         const Numbers& rotation, const std::string& engine) {
        const FlowOptions options{.viscosity = viscosity,
                                  .facets = boundary_of(no_slip, open, FlowBoundary::open,
                                                        mesh.size(mesh.dimension() - 1)),
                                  .boundary_flux = vector(boundary_flux),
                                  .wall_velocity = rows(wall_velocity),
                                  .rotation = vector(rotation),
                                  .linear_solver = engine};
        return guarded<IncompressibleFlow>(mesh, options);
    }));
    const std::pair<const char*, FlowMap> maps[] = {
        {"project", &IncompressibleFlow::project},
        {"vorticity", &IncompressibleFlow::vorticity},
        {"inertia", &IncompressibleFlow::inertia},
        {"friction", &IncompressibleFlow::friction},
        {"rate", &IncompressibleFlow::rate},
        {"momentum", &IncompressibleFlow::momentum},
        {"circulations", &IncompressibleFlow::circulations}};
    for (const auto& [name, map] : maps)
        flow.def(name, [map = map](Flow& self, const Numbers& w) {
            return array(self.use(
                [&, given = vector(w)](const IncompressibleFlow& of) { return (of.*map)(given); }));
        });
    const std::pair<const char*, FlowNumber> numbers[] = {
        {"energy", &IncompressibleFlow::energy},
        {"dissipation", &IncompressibleFlow::dissipation},
        {"divergence", &IncompressibleFlow::divergence},
        {"exchange_time", &IncompressibleFlow::exchange_time}};
    for (const auto& [name, number] : numbers)
        flow.def(name, [number = number](Flow& self, const Numbers& w) {
            return self.use([&, given = vector(w)](const IncompressibleFlow& of) {
                return (of.*number)(given);
            });
        });
    flow.def("pressure", [](Flow& self, const Numbers& w) {
        return array(self.use([&, given = vector(w)](const IncompressibleFlow& of) {
            return of.pressure(given).values;
        }));
    });
}

void add_flux_transport(py::module_& module) {
    py::class_<FluxTransport>(module, "FluxTransport")
        .def(py::init([](const Discretization& mesh, const std::string& sampling) {
            return std::make_unique<FluxTransport>(mesh, sampling_of(sampling));
        }))
        .def("mass_flux",
             [](const FluxTransport& self, const Numbers& flux, const Numbers& density,
                const Numbers& outside) {
                 return array(self.mass_flux(vector(flux), vector(density), vector(outside)));
             })
        .def("rate",
             [](const FluxTransport& self, const Numbers& flux, const Numbers& density,
                const Numbers& outside) {
                 return array(self.rate(vector(flux), vector(density), vector(outside)));
             })
        .def("stable_step", [](const FluxTransport& self,
                               const Numbers& flux) { return self.stable_step(vector(flux)); })
        .def("mass", [](const FluxTransport& self,
                        const Numbers& density) { return self.mass(vector(density)); })
        .def("outflow", [](const FluxTransport& self, const Numbers& mass_flux) {
            return self.outflow(vector(mass_flux));
        });
}

using Water = ShallowWater::State;

Water water(const Numbers& depth, const Numbers& flux) {
    return {vector(depth), vector(flux)};
}

py::tuple parts_of(Water state) {
    return py::make_tuple(array(std::move(state.depth)), array(std::move(state.flux)));
}

void add_shallow_water(py::module_& module) {
    using Flow = Guarded<ShallowWater>;
    py::class_<Flow> flow(module, "ShallowWater");
    flow.def(py::init([](const Discretization& mesh, double gravity, const Numbers& rotation,
                         const Numbers& bottom) {
            return guarded<ShallowWater>(
                mesh, ShallowWaterOptions{gravity, vector(rotation), vector(bottom)});
        }))
        .def("rate",
             [](Flow& self, const Numbers& depth, const Numbers& flux) {
                 return parts_of(self.use(
                     [&, now = water(depth, flux)](ShallowWater& of) { return of.rate(now); }));
             })
        .def("reaction",
             [](Flow& self, double time, const Numbers& depth, const Numbers& flux) {
                 const std::vector<Cochain> forms{form("dual", 0, depth), form("primal", 1, flux)};
                 auto rates = self.use([&](const ShallowWater& of) { return of(time, forms); });
                 return parts_of({std::move(rates[0]), std::move(rates[1])});
             })
        .def("potential_vorticity", [](Flow& self, const Numbers& depth, const Numbers& flux) {
            return array(self.use([&, now = water(depth, flux)](const ShallowWater& of) {
                return of.potential_vorticity(now);
            }));
        });
    using Number = double (ShallowWater::*)(const Water&) const;
    const std::pair<const char*, Number> numbers[] = {
        {"mass", &ShallowWater::mass},
        {"energy", &ShallowWater::energy},
        {"potential_enstrophy", &ShallowWater::potential_enstrophy},
        {"stable_step", &ShallowWater::stable_step}};
    for (const auto& [name, number] : numbers)
        flow.def(name, [number = number](Flow& self, const Numbers& depth, const Numbers& flux) {
            return self.use([&, now = water(depth, flux)](const ShallowWater& of) {
                return (of.*number)(now);
            });
        });
}

void add_stokes(py::module_& module) {
    using Solver = Guarded<StokesSolver>;
    py::class_<Solver>(module, "StokesSolver")
        .def(py::init([](const Cells& of, double viscosity, const std::vector<bool>& no_slip,
                         const std::vector<bool>& known, const std::string& engine) {
            const StokesOptions options{.viscosity = viscosity,
                                        .facets =
                                            boundary_of(no_slip, known, FlowBoundary::pressure,
                                                        of.size(of.dimension() - 1)),
                                        .linear_solver = engine};
            return guarded<StokesSolver>(of, options);
        }))
        .def("solve", [](Solver& self, int degree, const Numbers& force,
                         const std::array<Numbers, 4>& known) {
            const auto& [through, along, vorticity, pressure] = known;
            StokesFlow found =
                self.use([&, given = form("primal", degree, force),
                          data = StokesData{vector(through), vector(along), vector(vorticity),
                                            vector(pressure)}](const StokesSolver& solver) {
                    return solver.solve(given, data);
                });
            return py::make_tuple(parts(std::move(found.flux)), parts(std::move(found.vorticity)),
                                  parts(std::move(found.pressure)), report_of(found.report));
        });
}

} // namespace

void add_flows(py::module_& module) {
    module.def("flow_of_vorticity", [](const Discretization& mesh, const Numbers& vorticity) {
        return array(
            unlocked([&, given = vector(vorticity)] { return flow_of_vorticity(mesh, given); }));
    });
    module.def("flow_of_velocity", [](const Discretization& mesh, const Numbers& velocity) {
        return array(
            unlocked([&, given = rows(velocity)] { return flow_of_velocity(mesh, given); }));
    });
    module.def("flux_through_boundary", [](const Discretization& mesh, const Numbers& velocity) {
        return array(
            unlocked([&, given = rows(velocity)] { return flux_through_boundary(mesh, given); }));
    });
    add_flow(module);
    add_shallow_water(module);
    add_flux_transport(module);
    add_stokes(module);
}

} // namespace polydec::python
