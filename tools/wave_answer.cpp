// SPDX-License-Identifier: MIT
#include "tools/wave_answer.h"

#include "dec/fields/flat_and_sharp.h"
#include "tools/picture.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace polydec::tools {

namespace {

struct Swung {
    FormFacts facts;
    Ran ran;
    LayerKind layer;
    double layer_width;
    std::optional<double> stable_step; // in the units of the file; none: any step is stable
    double min, max;
    std::optional<double> energy, relative_energy; // at the end, in the units of the file

    void write(JsonWriter& json) const {
        facts.write_form(json);
        ran.write(json);
        json.member("stable_step", stable_step);
        json.member("min", min);
        json.member("max", max);
        json.member("energy", energy);
        json.member("relative_energy", relative_energy);
        if (layer_width > 0)
            json.member("layer", name(layer));
        facts.write_conditions(json);
    }

    void write(Text& text) const {
        text("waves of {} {}-forms, {}\n  {}\n  {}\n", name(facts.side), facts.degree,
             ran.in_words(), facts.conditions, in_words(facts.stars));
        if (layer_width > 0)
            text("  an absorbing layer of width {:.6g}, {}\n", layer_width, name(layer));
        text("  steps {}\n", stable_step ? fmt::format("are stable below {:.6g}", *stable_step)
                                         : "of any length are stable");
        text("  values from {:.10g} to {:.10g}; energy {}{}\n", min, max, in_digits(energy),
             in_words(relative_energy));
    }
};

/// E and B. Of a magnetic field in the plane, which is a flux through edges, the vectors.
std::vector<NamedForm> shown(const WaveWords& words, const Discretization& mesh,
                             std::vector<Cochain> forms) {
    NamedForm upper(words.upper, std::move(forms[1]), words.upper_words);
    if (words.upper_is_flux && upper.form.degree == 1 && has_proxy(mesh, upper.form))
        upper = flux_vectors(words.upper, mesh, upper.form, words.upper_words);
    return {NamedForm(words.form, std::move(forms[0]), words.form_words), std::move(upper)};
}

} // namespace

void answer_waves(const WaveWords& words, const Discretization& mesh, const FormSpace& space,
                  const Vector& start, WaveOptions options, const TellOptions& tell_options,
                  const TimeArguments& time, Log& log) {
    log.timing.begin("solve");
    const FormFacts facts{space.side(), space.degree(), space.in_words(), mesh.chosen_stars()};
    const double stable = computed(log, "find the stable step", [&] { return stable_step(space); });
    const TimeSteps steps = time_steps(time, part_of_stable_step * stable);
    options.time_step = steps.length;
    Waves run(space, start, options);
    log.warn(run.warnings());
    const March march{words.what, page_of(log, words.title, facts.beside(words.equation)), steps,
                      [&](const Run& now) { return shown(words, mesh, now.forms()); }};
    const Ran ran = march_to_end(run, march, time, mesh, log);
    const Vector E = run.form(0).values;
    const Swung answer{facts,
                       ran,
                       run.layer(),
                       options.layer ? options.layer->width : 0,
                       std::isfinite(stable) ? std::optional(stable) : std::nullopt,
                       E.minCoeff(),
                       E.maxCoeff(),
                       in_range([&] { return run.energy(); }),
                       run.relative_energy()};
    tell(answer, log, tell_options);
}

} // namespace polydec::tools
