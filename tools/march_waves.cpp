// SPDX-License-Identifier: MIT
#include "tools/march_waves.h"

#include "dec/conditioned_complex.h"
#include "dec/forms/cochain.h"
#include "io/diagnosis_json.h"
#include "tools/picture.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <optional>

namespace polydec::tools {

namespace {

constexpr double part_of_stable_step = 0.9;

struct Swung : Answer {
    std::string what;
    Side side;
    int degree;
    TimeSteps steps = {};
    Ran ran;
    std::string conditions;
    LayerKind layer = LayerKind::automatic; // none
    double layer_width = 0;
    std::optional<double> stable_step; // in the units of the file; none: any step is stable
    double min = 0, max = 0;
    std::optional<double> energy, relative_energy; // at the end, in the units of the file
    ChosenStars stars;

    Swung(const WaveProblem& problem, const ChosenStars& chosen)
        : what(problem.what),
          side(problem.side),
          degree(problem.degree),
          layer_width(problem.options.layer.width),
          stars(chosen) {}

    void write(JsonWriter& json) const override {
        json.member("side", name(side));
        json.member("degree", degree);
        write_time(json, steps, ran);
        json.member("stable_step", stable_step);
        json.member("min", min);
        json.member("max", max);
        json.member("energy", energy);
        json.member("relative_energy", relative_energy);
        if (layer_width > 0)
            json.member("layer", name(layer));
        json.member("conditions", conditions);
        write_stars(json, stars);
    }

    void write(Text& text) const override {
        text("waves of {} {}-forms, {}\n", name(side), degree, in_words(steps, ran));
        text("  {}\n  {}\n", conditions, in_words(stars));
        if (layer_width > 0)
            text("  an absorbing layer of the width {:.6g}, {}\n", layer_width, name(layer));
        text("  steps {}\n", stable_step ? fmt::format("are stable below {:.6g}", *stable_step)
                                         : "of any length are stable");
        text("  values from {:.10g} to {:.10g}; energy {}{}\n", min, max, in_digits(energy),
             in_words(relative_energy));
    }
};

/// What a march keeps: E, B, the memories of a layer, and the number of steps done.
enum Kept : std::size_t { of_E, of_B, of_E_memory, of_B_memory, of_steps };

/// E and B, which begins half a step before it, at rest; 0 where the conditions say so.
std::vector<Vector> at_rest(const WaveProblem& problem, const Discretization& mesh, double step) {
    const auto [side, degree] = std::pair{problem.side, problem.degree};
    const auto space = conditioned_complex(mesh, side, degree, problem.conditions);
    const int k = cell_degree(mesh.complex(), side, degree);
    const Vector E = space.relative.extend(k, space.relative.restrict(k, problem.start));
    return {E, step / 2 * d(mesh.complex(), {side, degree, E}).values, Vector(), Vector(),
            Vector::Zero(1)};
}

void step(const Leapfrog& leapfrog, const WaveProblem& problem, std::vector<Vector>& state) {
    WaveSources sources;
    double& done = state[of_steps][0];
    if (problem.source.size() > 0) {
        const double middle = leapfrog.time_step() * (done + 0.5);
        sources.E = problem.pulse(middle) * problem.source;
    }
    WaveState wave{std::move(state[of_E]), std::move(state[of_B]), std::move(state[of_E_memory]),
                   std::move(state[of_B_memory])};
    leapfrog.step(wave, sources);
    state[of_E] = std::move(wave.E);
    state[of_B] = std::move(wave.B);
    state[of_E_memory] = std::move(wave.E_memory);
    state[of_B_memory] = std::move(wave.B_memory);
    done += 1;
}

polydec::Fingerprint fingerprint(const WaveProblem& problem, const Discretization& mesh) {
    polydec::Fingerprint result;
    result.add(mesh).add(problem.start).add(problem.source).add(problem.pulse_text);
    result.add(name(problem.side)).add(static_cast<std::uint64_t>(problem.degree));
    result.add(in_words(problem.conditions, mesh.complex(), problem.degree));
    result.add(problem.conditions);
    result.add(problem.options.loss).add(problem.options.layer.width);
    return result.add(name(problem.options.layer.kind));
}

} // namespace

void march_waves(WaveProblem problem, const Discretization& mesh, const MeshArguments& arguments,
                 const TimeArguments& time, Log& log) {
    const Side side = problem.side;
    const int degree = problem.degree;
    log.timing.begin("solve");
    Swung answer(problem, mesh.chosen_stars());
    const double stable = computed_on(arguments.mesh, [&] {
        const Progress progress;
        progress("find the stable step");
        return stable_step(mesh, problem.conditions, side, degree);
    });
    if (std::isfinite(stable))
        answer.stable_step = stable;
    answer.steps = time_steps(time, part_of_stable_step * stable);
    problem.options.time_step = answer.steps.length;
    const Leapfrog leapfrog(mesh, problem.conditions, side, degree, problem.options);
    answer.layer = leapfrog.layer();
    answer.conditions = in_words(problem.conditions, mesh.complex(), degree);
    PageText text;
    text.title = problem.title;
    text.facts = {problem.equation, answer.conditions, in_words(answer.stars)};
    March march{problem.what, in_page(std::move(text), log), answer.steps, {}, {}, {}, {}};
    march.state = at_rest(problem, mesh, answer.steps.length);
    const WaveState before{march.state[of_E], march.state[of_B]};
    march.step = [&](std::vector<Vector>& state) { step(leapfrog, problem, state); };
    march.shown = [&](const std::vector<Vector>& state) {
        return std::vector{
            NamedForm(problem.form, {side, degree, state[of_E]}, problem.form_words)};
    };
    march.problem = fingerprint(problem, mesh);
    answer.ran = run(march, time, mesh);
    answer.min = march.state[of_E].minCoeff();
    answer.max = march.state[of_E].maxCoeff();
    const WaveState after{march.state[of_E], march.state[of_B]};
    answer.energy = in_range([&] { return leapfrog.energy(after.E, after.B); });
    answer.relative_energy = leapfrog.relative_energy(after, before);
    tell(answer, log, arguments.tell);
}

} // namespace polydec::tools
