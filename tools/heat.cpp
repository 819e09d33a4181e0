// SPDX-License-Identifier: MIT
#include "solvers/heat.h"

#include "base/errors.h"
#include "dec/forms/cochain.h"
#include "io/diagnosis_json.h"
#include "tools/commands.h"
#include "tools/common.h"
#include "tools/conditions.h"
#include "tools/form_values.h"
#include "tools/in_time.h"
#include "tools/messages.h"
#include "tools/outputs.h"
#include "tools/picture.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <memory>
#include <optional>

namespace polydec::tools {

namespace {

struct HeatArguments {
    MeshArguments mesh;
    TimeArguments time;
    ConditionArguments conditions;
    Side side = Side::primal;
    int degree = 0;
    std::string initial;
    HeatOptions heat;
};

struct Cooled : Answer {
    Side side;
    int degree;
    TimeSteps steps;
    Ran ran;
    std::string conditions;
    double min, max, norm; // the last one as a part of that at the beginning
    ChosenStars stars;

    Cooled(const HeatArguments& arguments, const March& march, const Ran& how, std::string words,
           double part, const ChosenStars& chosen)
        : side(arguments.side),
          degree(arguments.degree),
          steps(march.steps),
          ran(how),
          conditions(std::move(words)),
          min(march.state[0].minCoeff()),
          max(march.state[0].maxCoeff()),
          norm(part),
          stars(chosen) {}

    void write(JsonWriter& json) const override {
        json.member("side", name(side));
        json.member("degree", degree);
        write_time(json, steps, ran);
        json.member("min", min);
        json.member("max", max);
        json.member("relative_norm", norm);
        json.member("conditions", conditions);
        write_stars(json, stars);
    }

    void write(Text& text) const override {
        text("heat equation for {} {}-forms, {}\n", name(side), degree, in_words(steps, ran));
        text("  {}\n  {}\n", conditions, in_words(stars));
        text("  values from {:.10g} to {:.10g}; L2 norm {:.6g} of that at the beginning\n", min,
             max, norm);
    }
};

double norm(const Discretization& mesh, const Cochain& form) {
    return std::sqrt(std::max(0.0, inner_product(mesh.complex(), mesh.stars(), form, form)));
}

void run_heat(HeatArguments arguments) {
    Log log;
    const FormValues initial("--initial", arguments.initial);
    const ConditionValues asked(arguments.conditions);
    check_time(arguments.time, initial.inputs(arguments.mesh.mesh, {asked.file()}));
    const Side side = arguments.side;
    const int degree = arguments.degree;
    const TimeSteps steps = time_steps(arguments.time, arguments.time.until / 100);
    const Discretization mesh = load(arguments.mesh, log);
    if (!arguments.time.out.empty())
        check_drawable(mesh);
    const auto conditions = asked.on(mesh).value_or(built_in_conditions(side));
    const Cochain start = initial.on(mesh, side, degree);
    arguments.heat.time_step = steps.length / (mesh.unit() * mesh.unit());
    log.timing.begin("solve");
    const auto solver = computed_on(arguments.mesh.mesh, [&] {
        const Progress progress;
        progress("factorize");
        return HeatSolver(mesh, conditions, side, degree, arguments.heat);
    });
    const std::string words = in_words(conditions, mesh.complex(), degree);
    PageText text;
    text.title = fmt::format("{}: heat", arguments.mesh.mesh.filename().string());
    text.facts = {fmt::format("du/dt = -Delta u of a {} {}-form, u = {} at the time 0", name(side),
                              degree, arguments.initial),
                  words, in_words(mesh.chosen_stars())};
    March march{"heat", in_page(std::move(text), log), steps, {start.values}, {}, {}, {}};
    march.step = [&](std::vector<Vector>& state) {
        state[0] = computed_on(arguments.mesh.mesh, [&] {
            return solver.step({side, degree, std::move(state[0])}).values;
        });
    };
    march.shown = [&](const std::vector<Vector>& state) {
        return std::vector{NamedForm("u", {side, degree, state[0]}, "the heat")};
    };
    march.problem.add(mesh).add(start.values).add(name(side)).add(words);
    march.problem.add(static_cast<std::uint64_t>(arguments.heat.scheme));
    for (const auto condition : conditions.facets)
        march.problem.add(static_cast<std::uint64_t>(condition));
    const Ran ran = run(march, arguments.time, mesh);
    const double before = norm(mesh, start);
    const double after = norm(mesh, {side, degree, march.state[0]});
    tell(Cooled(arguments, march, ran, words, before > 0 ? after / before : 0, mesh.chosen_stars()),
         log, arguments.mesh.tell);
}

} // namespace

void add_heat(CLI::App& app) {
    auto* command = app.add_subcommand("heat", "marches the heat equation du/dt = -Delta u");
    const auto arguments = std::make_shared<HeatArguments>();
    add_mesh_arguments(*command, arguments->mesh);
    add_star(*command, arguments->mesh, StarKind::automatic);
    add_side(*command, arguments->side)->required();
    command->add_option("--degree", arguments->degree, "degree of the forms")
        ->capture_default_str();
    add_form(*command, "--initial", arguments->initial, "the form at time 0");
    add_time(*command, arguments->time, "a hundredth of the time");
    command
        ->add_option("--scheme", arguments->heat.scheme,
                     "backward-euler, of first order, makes no new extremes;\n"
                     "crank-nicolson is of second order")
        ->transform(CLI::CheckedTransformer(
            std::map<std::string, HeatScheme>{{"backward-euler", HeatScheme::backward_euler},
                                              {"crank-nicolson", HeatScheme::crank_nicolson}},
            CLI::ignore_underscore))
        ->default_str("backward-euler");
    add_conditions(*command, arguments->conditions,
                   "no flow through the boundary (Neumann); of forms of degree\n"
                   "1 .. n-1 the normal part is 0 there",
                   "values 0 (Dirichlet) at boundary facets where this is not 0, of\n"
                   "forms of degree 1 .. n-1 the tangential part; no flow through\n"
                   "the others");
    command->add_option("--engine", arguments->heat.linear_solver, "linear solver")
        ->capture_default_str();
    command->footer(
        "On the boundary, primal forms have what --natural asks for unless told otherwise; dual "
        "forms\nhave values 0 (Dirichlet).\n\nExamples:\n"
        "  polydec heat bunny.off --side primal --initial 'x>0' --until .01 -o heat.html\n"
        "  polydec heat room.msh --side dual --initial 1 --until 2 --frames 100 -o heat.pvd \\\n"
        "      --checkpoint heat.checkpoint --resume");
    command->callback([arguments] { run_heat(*arguments); });
}

} // namespace polydec::tools
