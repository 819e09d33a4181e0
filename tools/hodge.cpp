// SPDX-License-Identifier: MIT
#include "solvers/sources/hodge.h"

#include "base/errors.h"
#include "tools/commands.h"
#include "tools/common.h"
#include "tools/conditions.h"
#include "tools/form_values.h"
#include "tools/picture.h"

#include <fmt/format.h>

#include <optional>

namespace polydec::tools {

namespace {

struct HodgeArguments {
    MeshArguments mesh;
    ConditionArguments conditions;
    Side side = Side::primal;
    int degree = 1;
    std::string form, engine = "auto";
    PictureArguments picture;
};

/// L2 norms, in the units of the file; none that are no numbers there.
struct Divided {
    FormFacts facts;
    std::optional<double> form, exact, coexact, harmonic;

    void write(JsonWriter& json) const {
        facts.write_form(json);
        json.object("norms", [&] {
            json.member("form", form);
            json.member("exact", exact);
            json.member("coexact", coexact);
            json.member("harmonic", harmonic);
        });
        facts.write_conditions(json);
    }

    void write(Text& text) const {
        text("Hodge decomposition of a {} {}-form\n  {}\n  {}\n", name(facts.side), facts.degree,
             facts.conditions, in_words(facts.stars));
        text("  L2 norms: form {}, exact {}, coexact {}, harmonic {}\n", in_digits(form),
             in_digits(exact), in_digits(coexact), in_digits(harmonic));
    }
};

void draw(const HodgeArguments& arguments, const Discretization& mesh, const Cochain& form,
          const HodgeParts& parts, const FormFacts& facts, const Log& log) {
    const std::string sum =
        fmt::format("The {} {}-form {} is the sum of three, orthogonal to each other",
                    name(form.side), form.degree, arguments.form);
    write_picture(arguments.picture, mesh,
                  {{"form", form, "the form that is split"},
                   {"exact", parts.exact, "d of a form"},
                   {"coexact", parts.coexact, "the codifferential of a form"},
                   {"harmonic", parts.harmonic, "neither, from the topology"}},
                  page_of(log, "Hodge decomposition", facts.beside(sum)), {}, log);
}

void run_hodge(const HodgeArguments& arguments) {
    Log log;
    const FormValues given("--form", arguments.form);
    const ConditionValues asked(arguments.conditions);
    check_picture(arguments.picture);
    const Discretization mesh = load(arguments.mesh, log, arguments.picture.out);
    Cochain form{arguments.side, arguments.degree,
                 given.on(mesh, arguments.side, arguments.degree)};
    const FormSpace space = asked.space(mesh, arguments.side, arguments.degree, log.mesh);
    log.timing.begin("solve");
    form.values = space.extend(space.restrict(form.values));
    const HodgeParts parts =
        computed(log, "solve", [&] { return hodge_decomposition(space, form, arguments.engine); });
    const auto norm_of = [&](const Cochain& part) {
        const Cochain kept{part.side, part.degree, space.restrict(part.values)};
        return in_range([&] { return norm(space.inside(), kept); });
    };
    const Divided answer{{form.side, form.degree, space.in_words(), mesh.chosen_stars()},
                         norm_of(form),
                         norm_of(parts.exact),
                         norm_of(parts.coexact),
                         norm_of(parts.harmonic)};
    if (!arguments.picture.out.empty()) {
        log.timing.begin("write");
        draw(arguments, mesh, form, parts, answer.facts, log);
    }
    tell(answer, log, arguments.mesh.tell);
}

} // namespace

void add_hodge(CLI::App& app) {
    const auto [command, arguments] = add_command<HodgeArguments>(
        app, "hodge", "splits a form into an exact, a coexact and a harmonic part", run_hodge);
    add_form(*command, "--form", arguments->form, "the form")->required();
    add_forms(*command, arguments->side, arguments->degree);
    add_mesh_arguments(*command, arguments->mesh, StarKind::automatic);
    add_conditions(*command, arguments->conditions,
                   "for 1-forms, the coexact and harmonic parts have normal part 0 on the "
                   "boundary; default of primal forms",
                   "all parts have tangential part 0 at boundary facets where this is not 0; "
                   "default of dual forms: 1");
    add_picture(*command, arguments->picture, "the form and its parts");
    add_engine(*command, arguments->engine);
    command->footer("Values that a boundary condition fixes do not enter the decomposition.\n\n"
                    "Examples:\n"
                    "  polydec hodge torus.off --form '-y; x; z' -o parts.html\n"
                    "  polydec hodge ball.mesh --side dual --degree 2 --form '0; x; 1' --json");
}

} // namespace polydec::tools
