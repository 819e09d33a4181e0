// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "dec/forms/cochain.h"
#include "solvers/time/evolution.h"
#include "tools/commands.h"
#include "tools/common.h"
#include "tools/conditions.h"
#include "tools/form_values.h"
#include "tools/in_time.h"
#include "tools/picture.h"

#include <fmt/format.h>

#include <optional>

namespace polydec::tools {

namespace {

struct HeatArguments {
    MeshArguments mesh;
    TimeArguments time;
    ConditionArguments conditions;
    Side side = Side::primal;
    int degree = 0;
    std::string initial, source, boundary, flux;
    std::string integrator, engine = "auto";
    double tolerance = 0; ///< 0: none is asked for

    /// The default: "runge-kutta" if there is a tolerance, a source or boundary data, otherwise
    /// "backward-euler". Throws InvalidInput for a tolerance with an integrator of fixed steps.
    void choose_integrator() {
        const bool changes = tolerance > 0 || !source.empty() || !boundary.empty() || !flux.empty();
        if (integrator.empty())
            integrator = changes ? "runge-kutta" : "backward-euler";
        if (tolerance > 0 && has_equal_steps())
            throw InvalidInput(fmt::format("--tolerance-in-time: {} takes equal steps and does not "
                                           "estimate errors; use --integrator runge-kutta, or omit "
                                           "the tolerance",
                                           integrator));
    }
    bool has_equal_steps() const {
        return integrator == "backward-euler" || integrator == "implicit-midpoint";
    }
};

/// What heat is marched with: the mesh, and what was asked for on it.
struct Heat {
    const HeatArguments& arguments;
    const Discretization& mesh;
    Cochain start;
    FormSpace space;
    std::optional<FormValues> source, boundary, flux;
};

struct Cooled {
    FormFacts facts;
    Ran ran;
    double min, max;
    std::optional<double> norm, relative_norm;
    IntegratorReport integrated;
    bool has_equal_steps;

    Cooled(const FormFacts& known, const Heat& heat, const Ran& how, const Evolution& run)
        : facts(known),
          ran(how),
          integrated(run.report()),
          has_equal_steps(heat.arguments.has_equal_steps()) {
        const Cochain end = run.form(0);
        min = end.values.minCoeff();
        max = end.values.maxCoeff();
        norm = in_range([&] { return polydec::norm(heat.mesh, end); });
        const Cells in_unit(heat.mesh.complex(), heat.mesh.stars()); // both are in range there
        const auto size = [&](const Cochain& form) {
            return in_range([&] { return polydec::norm(in_unit, form); });
        };
        if (const auto now = size(end), before = size(heat.start); now && before && *before > 0)
            relative_norm = *now / *before;
    }

    void write(JsonWriter& json) const {
        facts.write_form(json);
        ran.write(json);
        json.member("integrator", integrated.engine);
        if (!has_equal_steps) {
            json.member("integrator_steps", integrated.steps);
            json.member("integrator_rejected", integrated.rejected);
            json.member("integrator_last_step", integrated.last_step);
        }
        json.member("min", min);
        json.member("max", max);
        json.member("relative_norm", relative_norm);
        facts.write_conditions(json);
    }

    void write(Text& text) const {
        text("heat equation for {} {}-forms, {}\n", name(facts.side), facts.degree, ran.in_words());
        if (!has_equal_steps)
            text(
                "  divided by {} into {} steps{}, {} of them taken again, the last one of {:.6g}\n",
                integrated.engine, integrated.steps, ran.resumed_at > 0 ? " since then" : "",
                integrated.rejected, integrated.last_step);
        text("  {}\n  {}\n", facts.conditions, in_words(facts.stars));
        text("  values from {:.10g} to {:.10g}; L2 norm {}{}\n", min, max, in_digits(norm),
             in_words(relative_norm));
    }
};

/// By equal steps, or from frame to frame by as many as the tolerance asks for.
Evolution run_of(const Heat& heat, const TimeSteps& steps) {
    // the same value at all times where an expression does not use the time, none without one
    const auto in_time = [&heat](const std::optional<FormValues>& values,
                                 auto member) -> std::function<Vector(double)> {
        const auto at = [&heat, given = &values, member](double t) {
            return ((**given).*member)(heat.mesh, heat.start.side, heat.start.degree, t);
        };
        if (values && values->uses_time())
            return at;
        return [value = values ? at(0) : Vector()](double) { return value; };
    };
    Unknown unknown{.space = heat.space, .start = heat.start.values, .diffusion = 1};
    if (heat.boundary || heat.flux)
        unknown.boundary = [values = in_time(heat.boundary, &FormValues::on_boundary),
                            flow = in_time(heat.flux, &FormValues::through_boundary)](double t) {
            return BoundaryForms{.values = values(t), .derivative_flow = flow(t)};
        };
    Reaction reaction;
    if (heat.source)
        reaction = [rate = in_time(heat.source, &FormValues::on)](
                       double t, const std::vector<Cochain>&) { return std::vector{rate(t)}; };
    EvolutionOptions options{.integrator = heat.arguments.integrator,
                             .linear_solver = heat.arguments.engine,
                             .label = "data"};
    for (const auto& [values, text] : {std::pair(&heat.source, heat.arguments.source),
                                       {&heat.boundary, heat.arguments.boundary},
                                       {&heat.flux, heat.arguments.flux}})
        options.label += *values && (*values)->uses_time() ? "; in time " + text : "; fixed";
    options.steps.fixed_step =
        heat.arguments.has_equal_steps() ? steps.length : heat.arguments.time.time_step;
    if (heat.arguments.tolerance > 0)
        options.steps.relative_tolerance = heat.arguments.tolerance;
    return {{unknown}, reaction, options};
}

void run_heat(HeatArguments arguments) {
    Log log;
    const FormValues initial("--initial", arguments.initial);
    auto source = if_given<FormValues>("--source", arguments.source, "t");
    auto boundary = if_given<FormValues>("--boundary-values", arguments.boundary, "t");
    auto flux = if_given<FormValues>("--flux", arguments.flux, "t");
    const ConditionValues asked(arguments.conditions);
    arguments.choose_integrator();
    check_time(arguments.time);
    const Side side = arguments.side;
    const int degree = arguments.degree;
    auto time = arguments.time;
    if (!arguments.has_equal_steps())
        time.time_step = 0; // which is the integrator's
    const TimeSteps steps = time_steps(time, time.until / (arguments.has_equal_steps() ? 100 : 1));
    const Discretization mesh = load(arguments.mesh, log, arguments.time.out);
    const FormSpace space = asked.space(mesh, side, degree, log.mesh);
    space.require_use({.values = arguments.boundary.empty() ? "" : "--boundary-values",
                       .flow = arguments.flux.empty() ? "" : "--flux"});
    const Heat heat{arguments,
                    mesh,
                    {side, degree, initial.on(mesh, side, degree)},
                    space,
                    std::move(source),
                    std::move(boundary),
                    std::move(flux)};
    log.timing.begin("solve");
    const FormFacts facts{
        side, degree,
        space.in_words({.values = !arguments.boundary.empty(), .flow = !arguments.flux.empty()}),
        mesh.chosen_stars()};
    const std::string equation = fmt::format(
        "du/dt = -Delta u{} of a {} {}-form, u = {} at the time 0",
        heat.source ? " + " + arguments.source : "", name(side), degree, arguments.initial);
    const March march{
        "heat", page_of(log, "heat", facts.beside(equation)), steps,
        [](const Run& now) { return std::vector{NamedForm("u", now.form(0), "the heat")}; }};
    auto run = computed(log, "factorize", [&] { return run_of(heat, steps); });
    const Ran ran = march_to_end(run, march, arguments.time, mesh, log);
    tell(Cooled(facts, heat, ran, run), log, arguments.mesh.tell);
}

} // namespace

void add_heat(CLI::App& app) {
    const auto [command, arguments] = add_command<HeatArguments>(
        app, "heat", "solves the heat equation du/dt = -Delta u", run_heat);
    add_form(*command, "--initial", arguments->initial, "the form at time 0")->required();
    add_form(*command, "--source", arguments->source,
             "term added to du/dt; may use the time t, as may the data on the boundary");
    add_forms(*command, arguments->side, arguments->degree);
    add_mesh_arguments(*command, arguments->mesh, StarKind::automatic);
    add_conditions(*command, arguments->conditions);
    add_form(*command, "--boundary-values", arguments->boundary,
             "values at essential facets instead of 0");
    add_form(*command, "--flux", arguments->flux,
             "outward derivative of a 0-form elsewhere on the boundary, instead of 0");
    add_robin(*command, arguments->conditions, "--flux");
    add_fixed(*command, arguments->conditions, "values of --boundary-values");
    add_time(*command, arguments->time, "a hundredth of the time, or adaptive");
    command
        ->add_option("--tolerance-in-time", arguments->tolerance,
                     "E\trelative error allowed per step (default with a source: 1e-5)")
        ->check(check_positive)
        ->excludes("--time-step");
    command->add_option(
        "--integrator", arguments->integrator,
        "NAME\tequal steps: backward-euler (default; order 1), implicit-midpoint (order 2); by "
        "error: runge-kutta (default with tolerance, source, boundary data), cvode");
    add_engine(*command, arguments->engine);
    command->footer("Examples:\n"
                    "  polydec heat bunny.off --initial 'x>0' --until .01 -o heat.html\n"
                    "  polydec heat room.msh --initial 1 --until 2 -o heat.pvd --checkpoint "
                    "h.checkpoint --resume\n"
                    "  polydec heat plate.off --side dual --initial 1 --robin 2.5 --flux "
                    "'50+10*sin(t)' --until 1\n"
                    "  polydec heat room.msh --initial 0 --source 'x*sin(t)' --until 20 "
                    "--tolerance-in-time 1e-4");
}

} // namespace polydec::tools
