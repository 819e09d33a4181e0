// SPDX-License-Identifier: MIT
#include "solvers/waves.h"

#include "base/checks.h"
#include "base/errors.h"

#include <cmath>
#include <utility>

namespace polydec {

namespace {

/// Any step is stable where nothing swings.
LeapfrogOptions steps_of(const WaveOptions& options, const std::function<double()>& stable) {
    double step = options.time_step;
    if (step == 0) {
        const double limit = stable();
        step = std::isfinite(limit) ? part_of_stable_step * limit : 1;
    }
    return {step, options.loss, options.upper_loss, options.layer};
}

Leapfrog leapfrog_of(const Discretization& mesh, const Cochain& start, const WaveOptions& options) {
    const auto conditions = options.conditions.value_or(built_in_conditions(start.side));
    check(mesh.complex(), start);
    return {mesh, conditions, start.side, start.degree, steps_of(options, [&] {
                return stable_step(mesh, conditions, start.side, start.degree);
            })};
}

Leapfrog leapfrog_of(const CellComplex& complex, const HodgeStars& stars, const Cochain& start,
                     const WaveOptions& options) {
    if (options.conditions)
        throw InvalidInput("conditions are given for cells alone: expected the mesh");
    check(complex, start);
    return {complex, stars, start.side, start.degree, steps_of(options, [&] {
                return stable_step(complex, stars, start.side, start.degree);
            })};
}

std::vector<Vector> begun(const Leapfrog& leapfrog, const Vector& E, const Vector& B) {
    WaveState state = leapfrog.at_rest(E);
    if (B.size() > 0) {
        check_as_many("values of B", B.size(), static_cast<Index>(state.B.size()));
        state.B = B;
    }
    return {state.E, state.B, state.E_memory, state.B_memory};
}

} // namespace

Waves::Waves(const Discretization& mesh, const Cochain& start, const WaveOptions& options)
    : Waves(leapfrog_of(mesh, start, options), start, options,
            [mesh] { return Fingerprint().add(mesh); }) {}

Waves::Waves(const CellComplex& complex, const HodgeStars& stars, const Cochain& start,
             const WaveOptions& options)
    : Waves(leapfrog_of(complex, stars, start, options), start, options,
            [complex, stars] { return Fingerprint().add(complex).add(stars); }) {}

Waves::Waves(Leapfrog leapfrog, const Cochain& start, WaveOptions options,
             std::function<Fingerprint()> cells)
    : FixedSteps(leapfrog.time_step(), begun(leapfrog, start.values, options.B)),
      leapfrog_(std::move(leapfrog)),
      side_(start.side),
      degree_(start.degree),
      options_(std::move(options)),
      start_(now()),
      cells_(std::move(cells)) {}

void Waves::step(std::vector<Vector>& state) const {
    WaveSources sources;
    if (options_.source)
        sources.E = options_.source(time() + time_step() / 2);
    if (options_.upper_source)
        sources.B = options_.upper_source(time());
    WaveState wave{state[0], state[1], state[2], state[3]};
    leapfrog_.step(wave, sources);
    state = {std::move(wave.E), std::move(wave.B), std::move(wave.E_memory),
             std::move(wave.B_memory)};
}

std::vector<Cochain> Waves::forms() const {
    return {{side_, degree_, now()[0]}, {side_, degree_ + 1, now()[1]}};
}

std::optional<Fingerprint> Waves::fingerprint() const {
    const bool has_functions = options_.source || options_.upper_source;
    if (has_functions && options_.label.empty())
        return std::nullopt;
    Fingerprint result = cells_();
    result.add("waves").add(options_.label).add(has_functions).add(side_).add(degree_);
    result.add(time_step()).add(options_.loss).add(options_.upper_loss);
    result.add(options_.conditions.value_or(built_in_conditions(side_)));
    const AbsorbingLayer& layer = options_.layer;
    result.add(layer.width).add(layer.kind).add(layer.reflection).add(layer.power);
    for (const auto& sides : layer.sides)
        result.add(sides[0]).add(sides[1]);
    for (const Vector& values : start_)
        result.add(values);
    if (options_.source)
        result.add(options_.source(time_step() / 2));
    if (options_.upper_source)
        result.add(options_.upper_source(0));
    return result;
}

double Waves::energy() const {
    return leapfrog_.energy(now()[0], now()[1]);
}

std::optional<double> Waves::relative_energy() const {
    return leapfrog_.relative_energy({now()[0], now()[1]}, {start_[0], start_[1]});
}

} // namespace polydec
