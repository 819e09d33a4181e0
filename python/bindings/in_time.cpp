// SPDX-License-Identifier: MIT
#include "python/bindings/calculus.h"
#include "python/bindings/convert.h"
#include "python/bindings/guarded.h"
#include "solvers/evolution.h"
#include "solvers/heat.h"
#include "solvers/leapfrog.h"

#include <array>

namespace polydec::python {

namespace {

HeatOptions heat_options(double time_step, const std::string& scheme, const std::string& engine) {
    return {time_step,
            chosen<HeatScheme>("scheme", scheme,
                               {{"backward_euler", HeatScheme::backward_euler},
                                {"crank_nicolson", HeatScheme::crank_nicolson}}),
            engine};
}

void add_heat(py::module_& module) {
    using Heat = Guarded<HeatSolver>;
    py::class_<Heat>(module, "HeatSolver")
        .def(py::init([](const Calculus& of, const GivenConditions& conditions,
                         const std::string& given_side, int degree, double time_step,
                         const std::string& scheme, const std::string& engine) {
            const HeatOptions options = heat_options(time_step, scheme, engine);
            const Side side = side_of(given_side);
            if (!conditions)
                return of.mesh ? guarded<HeatSolver>(*of.mesh, side, degree, options)
                               : guarded<HeatSolver>(of.complex, of.stars(), side, degree, options);
            return of.mesh ? guarded<HeatSolver>(*of.mesh, *conditions, side, degree, options)
                           : guarded<HeatSolver>(of.complex, of.stars(), *conditions, side, degree,
                                                 options);
        }))
        .def("step", [](Heat& self, const std::string& side, int degree, const Numbers& values,
                        Index steps) {
            Cochain now = form(side, degree, values);
            self.use([&](const HeatSolver& solver) {
                for (Index i = 0; i < steps; ++i) {
                    now = solver.step(now);
                    check_signals();
                }
            });
            return parts(std::move(now));
        });
}

/// What a function of Python's gives for a time, an As, made into something of polydec's; without
/// one nothing.
template <class As, class Make>
auto in_time(const py::object& function, Make make) {
    std::function<decltype(make(std::declval<As>()))(double)> result;
    if (!function.is_none())
        result = [kept = shared(function), make](double time) {
            return locked([&] { return make((*kept)(time).template cast<As>()); });
        };
    return result;
}

std::function<Vector(double)> values_in_time(const py::object& function) {
    return in_time<Numbers>(function, [](const Numbers& given) { return vector(given); });
}

py::list arrays_of(const std::vector<Cochain>& forms) {
    py::list result;
    for (const Cochain& form : forms)
        result.append(array(Vector(form.values)));
    return result;
}

Reaction reaction_of(const py::object& function) {
    if (function.is_none())
        return {};
    return [kept = shared(function)](double time, const std::vector<Cochain>& forms) {
        return locked(
            [&] { return vectors((*kept)(time, arrays_of(forms)).cast<std::vector<Numbers>>()); });
    };
}

std::function<double(double, const std::vector<Cochain>&)> event_of(const py::object& function) {
    if (function.is_none())
        return {};
    return [kept = shared(function)](double time, const std::vector<Cochain>& forms) {
        return locked([&] { return (*kept)(time, arrays_of(forms)).cast<double>(); });
    };
}

/// An unknown as Python names it: side, degree, values, diffusion, conditions, and a function for
/// the data on the boundary.
using GivenUnknown = std::tuple<std::string, int, Numbers, double, GivenConditions, py::object>;

std::vector<Unknown> unknowns_of(const std::vector<GivenUnknown>& given) {
    std::vector<Unknown> result;
    for (const auto& [side, degree, values, diffusion, conditions, boundary] : given) {
        Unknown unknown{
            .start = form(side, degree, values), .diffusion = diffusion, .conditions = conditions};
        unknown.boundary = in_time<GivenBoundary>(boundary, boundary_forms);
        result.push_back(std::move(unknown));
    }
    return result;
}

py::dict report_in_words(const IntegratorReport& report) {
    return py::dict(py::arg("engine") = report.engine, py::arg("steps") = report.steps,
                    py::arg("rejected") = report.rejected,
                    py::arg("evaluations") = report.evaluations,
                    py::arg("stiff_evaluations") = report.stiff_evaluations,
                    py::arg("preparations") = report.preparations,
                    py::arg("solves") = report.solves, py::arg("last_step") = report.last_step);
}

/// Tolerances, relative and absolute, and steps: the first, the largest and a fixed one.
using GivenSteps = std::tuple<double, double, double, double, double, Index>;

IntegratorOptions steps_of(const GivenSteps& given) {
    const auto& [relative, absolute, first, largest, fixed, most] = given;
    return {.relative_tolerance = relative,
            .absolute_tolerance = absolute,
            .first_step = first,
            .largest_step = largest,
            .fixed_step = fixed,
            .most_steps = most};
}

void add_evolution(py::module_& module) {
    using Run = Guarded<Evolution>;
    py::class_<Run>(module, "Evolution")
        .def(py::init([](const Calculus& of, const std::vector<GivenUnknown>& unknowns,
                         const py::object& reaction, const py::object& event, double time,
                         const std::string& integrator, const GivenSteps& steps,
                         const std::string& linear_solver) {
            const EvolutionOptions options{.time = time,
                                           .integrator = integrator,
                                           .steps = steps_of(steps),
                                           .linear_solver = linear_solver,
                                           .event = event_of(event),
                                           .progress = [](double) { check_signals(); }};
            const auto given = unknowns_of(unknowns);
            const auto rate = reaction_of(reaction);
            return of.mesh ? guarded<Evolution>(*of.mesh, given, rate, options)
                           : guarded<Evolution>(of.complex, of.stars(), given, rate, options);
        }))
        .def("march",
             [](Run& self, double until) {
                 return self.use([&](Evolution& run) { return run.march(until); }) ==
                        Arrival::at_event;
             })
        .def("time", [](Run& self) { return self.use([](Evolution& run) { return run.time(); }); })
        .def("forms",
             [](Run& self) {
                 return arrays_of(self.use([](Evolution& run) { return run.forms(); }));
             })
        .def("state",
             [](Run& self) { return arrays(self.use([](Evolution& run) { return run.state(); })); })
        .def("resume",
             [](Run& self, double time, const std::vector<Numbers>& state) {
                 self.use([&, given = vectors(state)](Evolution& run) { run.resume(time, given); });
             })
        .def("report", [](Run& self) {
            return report_in_words(self.use([](Evolution& run) { return run.report(); }));
        });
}

/// A layer as Python names it: width, kind, sides, reflection, power.
using GivenLayer =
    std::tuple<double, std::string, std::vector<std::array<bool, 2>>, double, double>;

AbsorbingLayer layer_of(const GivenLayer& given) {
    const auto& [width, kind, sides, reflection, power] = given;
    return {width,
            chosen<LayerKind>("the kind of a layer", kind,
                              {{"stretched", LayerKind::stretched},
                               {"conducting", LayerKind::conducting},
                               {"automatic", LayerKind::automatic}}),
            sides, reflection, power};
}

const Discretization& whole_mesh(const Calculus& of) {
    if (!of.mesh)
        throw InvalidInput("conditions or a layer are given for cells alone: expected the Complex "
                           "that discretize makes of a mesh");
    return *of.mesh;
}

std::unique_ptr<Guarded<Leapfrog>> waves_of(const Calculus& of, const std::string& given_side,
                                            int k, const GivenConditions& conditions,
                                            double time_step, const Numbers& loss,
                                            const Numbers& upper_loss, const GivenLayer& layer) {
    const Side side = side_of(given_side);
    const LeapfrogOptions options{time_step, vector(loss), vector(upper_loss), layer_of(layer)};
    if (!conditions && options.layer.width == 0 && !of.mesh)
        return guarded<Leapfrog>(of.complex, of.stars(), side, k, options);
    return guarded<Leapfrog>(whole_mesh(of), conditions.value_or(built_in_conditions(side)), side,
                             k, options);
}

/// Steps with sources, given as rates of E and of B at times.
void march(const Leapfrog& waves, WaveState& state, Index steps, double time,
           const std::function<Vector(double)>& source,
           const std::function<Vector(double)>& upper_source) {
    const double dt = waves.time_step();
    for (Index i = 0; i < steps; ++i) {
        const double now = time + i * dt;
        waves.step(state, {source ? source(now + dt / 2) : Vector(),
                           upper_source ? upper_source(now) : Vector()});
        check_signals();
    }
}

/// E and B, and what the layer remembers.
using GivenWave = std::tuple<Numbers, Numbers, Numbers, Numbers>;

void add_waves(py::module_& module) {
    using Waves = Guarded<Leapfrog>;
    py::class_<Waves>(module, "Leapfrog")
        .def(py::init(&waves_of))
        .def("march",
             [](Waves& self, const GivenWave& given, Index steps, double time,
                const py::object& source, const py::object& upper_source) {
                 const auto& [E, B, E_memory, B_memory] = given;
                 WaveState state{vector(E), vector(B), vector(E_memory), vector(B_memory)};
                 self.use([&, of_E = values_in_time(source),
                           of_B = values_in_time(upper_source)](const Leapfrog& waves) {
                     march(waves, state, steps, time, of_E, of_B);
                 });
                 return py::make_tuple(array(std::move(state.E)), array(std::move(state.B)),
                                       array(std::move(state.E_memory)),
                                       array(std::move(state.B_memory)));
             })
        .def("energy",
             [](Waves& self, const Numbers& E, const Numbers& B) {
                 return self.use(
                     [&, electric = vector(E), magnetic = vector(B)](const Leapfrog& waves) {
                         return waves.energy(electric, magnetic);
                     });
             })
        .def("layer", [](const Waves& self) { return name(self.solver.layer()); });
    module.def("stable_step", [](const Calculus& of, const std::string& given_side, int k,
                                 const GivenConditions& conditions) {
        const Side side = side_of(given_side);
        return unlocked([&] {
            return !conditions && !of.mesh
                       ? stable_step(of.complex, of.stars(), side, k)
                       : stable_step(whole_mesh(of), conditions.value_or(built_in_conditions(side)),
                                     side, k);
        });
    });
}

} // namespace

void add_in_time(py::module_& module) {
    add_heat(module);
    add_evolution(module);
    add_waves(module);
}

} // namespace polydec::python
