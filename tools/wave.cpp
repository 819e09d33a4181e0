// SPDX-License-Identifier: MIT
#include "tools/commands.h"
#include "tools/common.h"
#include "tools/conditions.h"
#include "tools/form_values.h"
#include "tools/messages.h"
#include "tools/outputs.h"
#include "tools/picture.h"
#include "tools/wave_answer.h"

#include <fmt/format.h>

#include <memory>

namespace polydec::tools {

namespace {

struct WaveArguments {
    MeshArguments mesh;
    TimeArguments time;
    ConditionArguments conditions;
    Side side = Side::primal;
    int degree = 0;
    std::string initial;
};

void run_wave(const WaveArguments& arguments) {
    Log log;
    const FormValues initial("--initial", arguments.initial);
    const ConditionValues asked(arguments.conditions);
    check_time(arguments.time, initial.inputs(arguments.mesh.mesh, {asked.file()}));
    const Discretization mesh = load(arguments.mesh, log);
    if (!arguments.time.out.empty())
        check_drawable(mesh);
    const WaveWords words{
        "wave", fmt::format("{}: waves", arguments.mesh.mesh.filename().string()),
        fmt::format("d2u/dt2 = -delta d u of a {} {}-form, u = {} at rest at the time 0",
                    name(arguments.side), arguments.degree, arguments.initial),
        "u", "the wave"};
    const auto space = computed_on(
        arguments.mesh.mesh, [&] { return asked.space(mesh, arguments.side, arguments.degree); });
    answer_waves(words, mesh, space, initial.on(mesh, arguments.side, arguments.degree).values, {},
                 arguments.mesh, arguments.time, log);
}

} // namespace

void add_wave(CLI::App& app) {
    auto* command = app.add_subcommand(
        "wave", "marches waves d2u/dt2 = -delta d u from rest; of 1-forms in space, Maxwell's");
    const auto arguments = std::make_shared<WaveArguments>();
    add_mesh_arguments(*command, arguments->mesh);
    add_star(*command, arguments->mesh, StarKind::automatic);
    add_side(*command, arguments->side)->default_str("primal");
    command->add_option("--degree", arguments->degree, "degree of the forms")
        ->capture_default_str();
    add_form(*command, "--initial", arguments->initial, "the form at time 0");
    add_time(*command, arguments->time, "0.9 of what is stable");
    add_conditions(*command, arguments->conditions,
                   "nothing flows through the boundary (Neumann); waves are thrown\n"
                   "back. What holds by itself for primal forms",
                   "values 0 (a clamped membrane; of 1-forms a perfect conductor) at\n"
                   "boundary facets where this is not 0; for dual forms 1 by itself");
    add_essential_on(*command, arguments->conditions);
    command->footer(
        "Steps are of second order, and conserve the energy to rounding.\n\nExamples:\n"
        "  polydec wave bunny.off --initial 'exp(-100*((x-.1)^2+y^2+z^2))' --until 1 -o wave.html\n"
        "  polydec wave drum.off --initial '1-x^2-y^2' --essential-where 1 --until 4 -o drum.pvd\n"
        "  polydec wave drum.off --side dual --initial '1-x^2-y^2' --until 4 -o drum.html");
    command->callback([arguments] { run_wave(*arguments); });
}

} // namespace polydec::tools
