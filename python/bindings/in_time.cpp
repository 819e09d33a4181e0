// SPDX-License-Identifier: MIT
#include "io/march.h"
#include "python/bindings/convert.h"
#include "python/bindings/guarded.h"
#include "solvers/flow/flow.h"
#include "solvers/time/evolution.h"
#include "solvers/time/time_steps.h"
#include "solvers/time/waves.h"

#include <array>

namespace polydec::python {

namespace {

std::vector<Vector> values_of(const std::vector<Cochain>& forms) {
    std::vector<Vector> values;
    for (const Cochain& form : forms)
        values.push_back(form.values);
    return values;
}

/// What a function of Python's gives for a time, and for forms at it; without one nothing.
template <class Value, class... Given>
std::function<Value(double, const Given&...)> in_time(const py::object& function) {
    if (function.is_none())
        return {};
    return [kept = shared(function)](double time, const Given&... forms) {
        return locked([&] { return (*kept)(time, values_of(forms)...).template cast<Value>(); });
    };
}

using Forms = std::vector<Cochain>;

/// An unknown as Python names it: space, values, diffusion, and a function for the data on the
/// boundary.
using GivenUnknown = std::tuple<FormSpace, Vector, double, py::object>;

std::vector<Unknown> unknowns_of(std::vector<GivenUnknown> given) {
    std::vector<Unknown> result;
    for (auto& [space, values, diffusion, boundary] : given)
        result.push_back({.space = space,
                          .start = std::move(values),
                          .diffusion = diffusion,
                          .boundary = in_time<BoundaryForms>(boundary)});
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
using GivenSteps = std::tuple<double, std::optional<double>, double, double, double, Index>;

IntegratorOptions steps_of(const GivenSteps& given) {
    const auto& [relative, absolute, first, largest, fixed, most] = given;
    return {.relative_tolerance = relative,
            .absolute_tolerance = absolute,
            .first_step = first,
            .largest_step = largest,
            .fixed_step = fixed,
            .most_steps = most};
}

/// A run of any kind, for one thread at a time.
using AnyRun = Guarded<std::unique_ptr<Run>>;

/// With its warnings.
template <class Kind, class... Arguments>
std::unique_ptr<AnyRun> run_of(const Arguments&... arguments) {
    auto made =
        unlocked([&] { return std::make_unique<AnyRun>(std::make_unique<Kind>(arguments...)); });
    warn(made->use([](auto& run) { return run->warnings(); }));
    return made;
}

/// What one kind of run alone can say, for which Python asks no others.
template <class Kind, class Work>
auto of_kind(AnyRun& self, Work work) {
    return self.use([&](auto& run) { return work(dynamic_cast<Kind&>(*run)); });
}

void let_ctrl_c_end(double) {
    check_signals();
}

struct GivenFrames {
    AnyRun& run;
    Frames frames;
};

void add_runs(py::module_& module) {
    py::class_<GivenFrames>(module, "Frames").def("next", [](GivenFrames& self) {
        return self.run.use([&](auto&) { return self.frames.next(); });
    });
    py::class_<AnyRun>(module, "Run")
        .def("march",
             [](AnyRun& self, double until, const py::object& progress) {
                 return self.use([&, tell = listener(progress)](auto& run) {
                     return run->march(until, announcing(*run, {until}, tell, let_ctrl_c_end));
                 }) == Arrival::at_event;
             })
        .def(
            "frames",
            [](AnyRun& self, const std::vector<double>& times, const std::string& checkpoint,
               const py::object& progress) {
                return self.use([&, tell = listener(progress)](auto& run) {
                    return std::unique_ptr<GivenFrames>(
                        new GivenFrames{self,
                                        {*run,
                                         times,
                                         {.checkpoint = checkpoint,
                                          .progress = let_ctrl_c_end,
                                          .announce = tell}}});
                });
            },
            py::keep_alive<0, 1>())
        .def("time", [](AnyRun& self) { return self.use([](auto& run) { return run->time(); }); })
        .def("forms",
             [](AnyRun& self) {
                 return values_of(self.use([](auto& run) { return run->forms(); }));
             })
        .def("state", [](AnyRun& self) { return self.use([](auto& run) { return run->state(); }); })
        .def("resume",
             [](AnyRun& self, double time, const std::vector<Vector>& state) {
                 self.use([&](auto& run) { run->resume(time, state); });
             })
        .def("report",
             [](AnyRun& self) {
                 return report_in_words(
                     of_kind<Evolution>(self, [](Evolution& run) { return run.report(); }));
             })
        .def("time_step",
             [](AnyRun& self) {
                 return of_kind<FixedSteps>(self, [](FixedSteps& run) { return run.time_step(); });
             })
        .def("energy",
             [](AnyRun& self) {
                 return of_kind<Waves>(self, [](Waves& run) { return run.energy(); });
             })
        .def("layer", [](AnyRun& self) {
            return of_kind<Waves>(self, [](Waves& run) { return name(run.layer()); });
        });
}

std::unique_ptr<AnyRun> evolution_of(std::vector<GivenUnknown> unknowns, const py::object& reaction,
                                     const py::object& event, double time,
                                     const std::string& integrator, const GivenSteps& steps,
                                     const std::string& linear_solver, const std::string& label) {
    const EvolutionOptions options{.time = time,
                                   .integrator = integrator,
                                   .steps = steps_of(steps),
                                   .linear_solver = linear_solver,
                                   .event = in_time<double, Forms>(event),
                                   .label = label};
    const auto given = unknowns_of(std::move(unknowns));
    const auto rate = in_time<std::vector<Vector>, Forms>(reaction);
    return run_of<Evolution>(given, rate, options);
}

/// A layer as Python names it: mesh, width, kind, sides, reflection, power; or none.
using GivenLayer = std::optional<std::tuple<Discretization, double, std::string,
                                            std::vector<std::array<bool, 2>>, double, double>>;

std::optional<AbsorbingLayer> layer_of(const GivenLayer& given) {
    if (!given)
        return std::nullopt;
    const auto& [mesh, width, kind, sides, reflection, power] = *given;
    return AbsorbingLayer{mesh,
                          width,
                          chosen<LayerKind>("the kind of a layer", kind,
                                            {{"stretched", LayerKind::stretched},
                                             {"conducting", LayerKind::conducting},
                                             {"automatic", LayerKind::automatic}}),
                          sides,
                          reflection,
                          power};
}

/// Losses of E and of B, and the B that E begins with; of them any may be empty.
using GivenWave = std::tuple<Vector, Vector, Vector>;

std::unique_ptr<AnyRun> waves_of(const FormSpace& space, const Vector& E, double time_step,
                                 const GivenWave& wave, const GivenLayer& layer,
                                 const py::object& source, const py::object& upper_source,
                                 const std::string& label) {
    const auto& [loss, upper_loss, B] = wave;
    const WaveOptions options{.time_step = time_step,
                              .loss = loss,
                              .upper_loss = upper_loss,
                              .layer = layer_of(layer),
                              .B = B,
                              .source = in_time<Vector>(source),
                              .upper_source = in_time<Vector>(upper_source),
                              .label = label};
    return run_of<Waves>(space, E, options);
}

std::unique_ptr<AnyRun> flow_of(const Guarded<IncompressibleFlow>& of, const Vector& start,
                                double time_step, const std::string& scheme, double tolerance,
                                int most_passes) {
    const FlowSteps steps{time_step,
                          chosen<FlowScheme>("scheme", scheme,
                                             {{"implicit_midpoint", FlowScheme::implicit_midpoint},
                                              {"imex", FlowScheme::imex}}),
                          tolerance, most_passes};
    return run_of<Flow>(of.solver, start, steps);
}

} // namespace

void add_in_time(py::module_& module) {
    add_runs(module);
    module.def("evolution", &evolution_of);
    module.def("waves", &waves_of);
    module.def("flow", &flow_of);
    module.def("stable_step", &stable_step, Unlocking());
    module.def("equal_step",
               [](double time, double longest) { return time_steps(time, longest).length; });
}

} // namespace polydec::python
