// SPDX-License-Identifier: MIT
#include "tools/commands.h"
#include "tools/common.h"
#include "tools/conditions.h"
#include "tools/form_values.h"
#include "tools/picture.h"
#include "tools/wave_answer.h"

#include <fmt/format.h>

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
    check_time(arguments.time);
    const Discretization mesh = load(arguments.mesh, log, arguments.time.out);
    const WaveWords words{
        "wave",
        "waves",
        fmt::format("d2u/dt2 = -delta d u of a {} {}-form, u = {} at rest at the time 0",
                    name(arguments.side), arguments.degree, arguments.initial),
        "u",
        "the wave",
        "v",
        "minus the integral of du over the time, half a step earlier"};
    const FormSpace space = asked.space(mesh, arguments.side, arguments.degree, log.mesh);
    answer_waves(words, mesh, space, initial.on(mesh, arguments.side, arguments.degree), {},
                 arguments.mesh.tell, arguments.time, log);
}

} // namespace

void add_wave(CLI::App& app) {
    const auto [command, arguments] = add_command<WaveArguments>(
        app, "wave", "solves the wave equation d2u/dt2 = -delta d u from rest (1-forms: Maxwell)",
        run_wave);
    add_form(*command, "--initial", arguments->initial, "the form at time 0")->required();
    add_forms(*command, arguments->side, arguments->degree);
    add_mesh_arguments(*command, arguments->mesh, StarKind::automatic);
    add_time(*command, arguments->time, "0.9 of the largest stable step");
    add_conditions(*command, arguments->conditions,
                   "no flow (Neumann), waves are reflected; default of primal forms",
                   "values 0 (clamped membrane; 1-forms: perfect conductor) at boundary facets "
                   "where this is not 0; default of dual forms: 1");
    command->footer(
        "Time steps have order 2 and conserve the energy up to rounding.\n\nExamples:\n"
        "  polydec wave bunny.off --initial 'exp(-100*((x-.1)^2+y^2+z^2))' --until 1 -o wave.html\n"
        "  polydec wave drum.off --initial '1-x^2-y^2' --essential-where 1 --until 4 -o drum.pvd\n"
        "  polydec wave drum.off --side dual --initial '1-x^2-y^2' --until 4 -o drum.html");
}

} // namespace polydec::tools
