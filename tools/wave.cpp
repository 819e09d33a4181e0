// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "dec/conditioned_complex.h"
#include "io/diagnosis_json.h"
#include "solvers/leapfrog.h"
#include "tools/commands.h"
#include "tools/common.h"
#include "tools/conditions.h"
#include "tools/form_values.h"
#include "tools/in_time.h"
#include "tools/messages.h"
#include "tools/outputs.h"
#include "tools/picture.h"

#include <fmt/format.h>

#include <memory>
#include <optional>

namespace polydec::tools {

namespace {

constexpr double part_of_stable_step = 0.9;

struct WaveArguments {
    MeshArguments mesh;
    TimeArguments time;
    ConditionArguments conditions;
    int degree = 0;
    std::string initial;
};

struct Swung : Answer {
    int degree = 0;
    TimeSteps steps = {};
    Ran ran;
    std::string conditions;
    double stable_step = 0; // in the units of the file
    double min = 0, max = 0;
    double energy = 0; // as a part of that at the beginning
    ChosenStars stars;

    explicit Swung(const ChosenStars& chosen) : stars(chosen) {}

    void write(JsonWriter& json) const override {
        json.member("side", name(Side::primal));
        json.member("degree", degree);
        write_time(json, steps, ran);
        json.member("stable_step", stable_step);
        json.member("min", min);
        json.member("max", max);
        json.member("relative_energy", energy);
        json.member("conditions", conditions);
        write_stars(json, stars);
    }

    void write(Text& text) const override {
        text("waves of primal {}-forms, {}\n", degree, in_words(steps, ran));
        text("  {}\n  {}\n", conditions, in_words(stars));
        text("  steps are stable below {:.6g}\n", stable_step);
        text("  values from {:.10g} to {:.10g}; energy {:.12g} of that at the beginning\n", min,
             max, energy);
    }
};

/// E and B, which begins half a step before it, at rest.
std::vector<Vector> at_rest(const CellComplex& complex, int degree, const Vector& E, double step) {
    return {E, step / 2 * d(complex, {Side::primal, degree, E}).values};
}

void run_wave(const WaveArguments& arguments) {
    Log log;
    const FormValues initial("--initial", arguments.initial);
    const ConditionValues asked(arguments.conditions);
    check_time(arguments.time, initial.inputs(arguments.mesh.mesh, {asked.file()}));
    const int degree = arguments.degree;
    const Discretization mesh = load(arguments.mesh, log);
    if (!arguments.time.out.empty())
        check_drawable(mesh);
    const auto conditions = asked.on(mesh).value_or(built_in_conditions(Side::primal));
    const Cochain start = initial.on(mesh, Side::primal, degree);
    log.timing.begin("solve");
    const auto space = conditioned_complex(mesh, Side::primal, degree, conditions);
    const CellComplex& complex = space.relative.complex;
    Swung answer(mesh.chosen_stars());
    answer.stable_step = mesh.unit() * computed_on(arguments.mesh.mesh, [&] {
                             const Progress progress;
                             progress("find the stable step");
                             return stable_step(complex, space.stars, degree);
                         });
    answer.steps = time_steps(arguments.time, part_of_stable_step * answer.stable_step);
    const double step = answer.steps.length / mesh.unit();
    const Leapfrog leapfrog(complex, space.stars, degree, step);
    answer.conditions = in_words(conditions, mesh.complex(), degree);
    PageText text;
    text.title = fmt::format("{}: waves", arguments.mesh.mesh.filename().string());
    text.facts = {fmt::format("d2u/dt2 = -delta d u of a primal {}-form, u = {} at rest at the "
                              "time 0",
                              degree, arguments.initial),
                  answer.conditions, in_words(answer.stars)};
    March march{"wave", in_page(std::move(text), log), answer.steps, {}, {}, {}, {}};
    march.state = at_rest(complex, degree, space.relative.restrict(degree, start.values), step);
    const double before = leapfrog.energy(march.state[0], march.state[1]);
    march.step = [&](std::vector<Vector>& state) { leapfrog.step(state[0], state[1]); };
    march.shown = [&](const std::vector<Vector>& state) {
        return std::vector{NamedForm(
            "u", {Side::primal, degree, space.relative.extend(degree, state[0])}, "the wave")};
    };
    march.problem.add(mesh).add(start.values).add(answer.conditions);
    for (const auto condition : conditions.facets)
        march.problem.add(static_cast<std::uint64_t>(condition));
    answer.degree = degree;
    answer.ran = run(march, arguments.time, mesh);
    const Vector E = space.relative.extend(degree, march.state[0]);
    answer.min = E.minCoeff();
    answer.max = E.maxCoeff();
    answer.energy = before > 0 ? leapfrog.energy(march.state[0], march.state[1]) / before : 0;
    tell(answer, log, arguments.mesh.tell);
}

} // namespace

void add_wave(CLI::App& app) {
    auto* command = app.add_subcommand(
        "wave", "marches waves d2u/dt2 = -delta d u from rest; of 1-forms in space, Maxwell's");
    const auto arguments = std::make_shared<WaveArguments>();
    add_mesh_arguments(*command, arguments->mesh);
    add_star(*command, arguments->mesh, StarKind::automatic);
    command->add_option("--degree", arguments->degree, "degree of the primal forms")
        ->capture_default_str();
    add_form(*command, "--initial", arguments->initial, "the form at time 0");
    add_time(*command, arguments->time, "0.9 of what is stable");
    add_conditions(*command, arguments->conditions,
                   "what holds by itself: nothing flows through the boundary\n"
                   "(Neumann); waves are thrown back",
                   "values 0 (a clamped membrane; of 1-forms a perfect conductor) at\n"
                   "boundary facets where this is not 0");
    command->footer(
        "Steps are of second order, and conserve the energy to rounding.\n\nExamples:\n"
        "  polydec wave bunny.off --initial 'exp(-100*((x-.1)^2+y^2+z^2))' --until 1 -o wave.html\n"
        "  polydec wave drum.off --initial '1-x^2-y^2' --essential-where 1 --until 4 -o drum.pvd");
    command->callback([arguments] { run_wave(*arguments); });
}

} // namespace polydec::tools
