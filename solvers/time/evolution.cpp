// SPDX-License-Identifier: MIT
#include "solvers/time/evolution.h"

#include "backends/integrators/equal_steps.h"
#include "backends/registry.h"
#include "base/errors.h"
#include "base/lists.h"
#include "meshes/unit_of_length.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace polydec {

namespace {

/// Sizes of cells, which turn values into coefficients; zero sizes become the mean.
Vector sizes_of_cells(const CellVolumes& volumes, Side side, int degree) {
    Vector sizes =
        side == Side::primal ? volumes.primal(degree) : volumes.dual(volumes.dimension() - degree);
    sizes = sizes.cwiseAbs();
    const double mean = sizes.size() > 0 ? sizes.mean() : 0;
    const double least = 1e-3;
    return mean > 0 ? Vector(sizes.cwiseMax(least * mean)) : Vector::Ones(sizes.size());
}

/// The unit of time that keeps diffusion rates in range: 1 if the largest coefficient in the unit
/// of the mesh is between 2^-80 and 2^80, else the power of two that scales it to 1 to 2, as far as
/// that is in range. If a reaction has its own pace, no unit is longer than 1.
double unit_of_time(const std::vector<Unknown>& unknowns, bool has_reaction) {
    constexpr int moderate = 80, most = 1000;
    std::optional<int> largest;
    for (const Unknown& unknown : unknowns)
        if (unknown.diffusion > 0 && std::isfinite(unknown.diffusion))
            largest = std::max(largest.value_or(std::numeric_limits<int>::min()),
                               std::ilogb(unknown.diffusion) -
                                   2 * std::ilogb(unknown.space.cells().unit()));
    if (!largest || std::abs(*largest) <= moderate)
        return 1;
    return std::ldexp(1.0, std::clamp(-*largest, -most, has_reaction ? 0 : most));
}

/// All times in this unit.
IntegratorOptions in_unit(IntegratorOptions steps, double unit) {
    for (double* time : {&steps.first_step, &steps.largest_step, &steps.fixed_step})
        *time /= unit;
    return steps;
}

} // namespace

/// The unknowns, and their free values as one vector, one unknown after the other. The integrator
/// has scaled times; all others are the caller's.
struct Evolution::Equation {
    struct Part {
        Unknown unknown;
        std::shared_ptr<const Diffusion> stiff; ///< or null
        std::optional<Resolvent> resolvent;     ///< of it
        std::vector<Index> kept;
        Index first;

        Index size() const { return static_cast<Index>(kept.size()); }
        Vector of(const Vector& values) const { return values.segment(first, size()); }
        BoundaryForms boundary(double time) const {
            return unknown.boundary ? unknown.boundary(time) : BoundaryForms{};
        }
    };

    std::vector<Part> parts;
    Reaction reaction;
    EvolutionOptions options;
    double unit = 1; ///< of time
    TimeListener progress;
    Vector start, scale;

    void add(const Unknown& unknown);
    std::vector<Cochain> forms(double time, const Vector& values) const;
    Vector rate(double time, const Vector& values) const;
    Vector stiff_rate(double time, const Vector& values) const;
    Vector solve(const Vector& b) const;
    InitialValueProblem problem(const std::shared_ptr<Equation>& self) const;
    std::optional<Fingerprint> fingerprint() const;
};

void Evolution::Equation::add(const Unknown& unknown) {
    const FormSpace& space = unknown.space;
    const Side side = space.side();
    const int degree = space.degree();
    space.check({side, degree, unknown.start});
    auto stiff = unknown.stiff;
    if (!stiff && unknown.diffusion != 0)
        stiff = std::make_shared<const Diffusion>(space, unknown.diffusion, options.linear_solver);
    const auto values = static_cast<Index>(unknown.start.size());
    if (stiff && (stiff->side() != side || stiff->degree() != degree || stiff->all() != values))
        throw InvalidInput(fmt::format("unknown {}: its stiff part acts on {} {}-forms of {} "
                                       "values, but the unknown is a {} {}-form of {}",
                                       parts.size(), name(stiff->side()), stiff->degree(),
                                       stiff->all(), name(side), degree, values));
    if (unknown.boundary && !stiff)
        throw InvalidInput(fmt::format("unknown {}: data on the boundary are given, but no "
                                       "diffusion uses them; add a diffusion or remove the data",
                                       parts.size()));
    std::vector<Index> kept = numbers_below(values);
    if (stiff)
        kept = stiff->kept();
    const Cells cells = space.cells();
    const Vector sizes = in_input_units(sizes_of_cells(cells.stars().volumes(), side, degree),
                                        cells.unit(), degree, "sizes of cells");
    const auto first = static_cast<Index>(start.size());
    start.conservativeResize(first + kept.size());
    scale.conservativeResize(first + kept.size());
    scale.tail(kept.size()) = sizes(kept);
    parts.push_back({unknown, std::move(stiff), {}, std::move(kept), first});
    Part& part = parts.back();
    if (part.stiff)
        part.resolvent.emplace(*part.stiff);
    start.tail(part.size()) =
        part.stiff ? part.stiff->values_of(unknown.start, part.boundary(options.time))
                   : unknown.start;
}

std::vector<Cochain> Evolution::Equation::forms(double time, const Vector& values) const {
    std::vector<Cochain> result;
    for (const Part& part : parts) {
        const FormSpace& space = part.unknown.space;
        const Vector now = part.of(values);
        result.push_back({space.side(), space.degree(),
                          part.stiff ? part.stiff->form_of(now, part.boundary(time)) : now});
    }
    return result;
}

Vector Evolution::Equation::rate(double time, const Vector& values) const {
    const auto rates = reaction(time, forms(time, values));
    if (rates.size() != parts.size())
        throw InvalidInput(fmt::format("the reaction gives rates of {} unknowns: expected {}",
                                       rates.size(), parts.size()));
    Vector result = Vector::Zero(values.size());
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const Part& part = parts[i];
        const auto expected = part.unknown.start.size();
        if (rates[i].size() != 0 && rates[i].size() != expected)
            throw InvalidInput(fmt::format("the reaction gives {} rates of unknown {}: expected "
                                           "{}, one for each cell, or none",
                                           rates[i].size(), i, expected));
        if (rates[i].size() != 0)
            result.segment(part.first, part.size()) =
                part.stiff ? part.stiff->values_of(rates[i]) : rates[i];
    }
    return result;
}

Vector Evolution::Equation::stiff_rate(double time, const Vector& values) const {
    Vector result = Vector::Zero(values.size());
    for (const Part& part : parts) {
        if (!part.stiff)
            continue;
        auto mine = result.segment(part.first, part.size());
        mine = part.stiff->rate(part.of(values));
        if (part.unknown.boundary)
            mine += part.stiff->boundary_rate(part.boundary(time));
    }
    return result;
}

Vector Evolution::Equation::solve(const Vector& b) const {
    Vector result = b;
    for (const Part& part : parts)
        if (part.stiff)
            result.segment(part.first, part.size()) = part.resolvent->solve(part.of(b));
    return result;
}

InitialValueProblem Evolution::Equation::problem(const std::shared_ptr<Equation>& self) const {
    InitialValueProblem result{.scale = scale};
    for (const Part& part : parts)
        result.parts.push_back(part.size());
    const bool is_stiff =
        std::any_of(parts.begin(), parts.end(), [](const Part& part) { return !!part.stiff; });
    const bool has_data = std::any_of(parts.begin(), parts.end(),
                                      [](const Part& part) { return !!part.unknown.boundary; });
    if (reaction || !is_stiff)
        result.rate = [self](double t, const Vector& y) {
            return self->reaction ? Vector(self->unit * self->rate(self->unit * t, y))
                                  : Vector(Vector::Zero(y.size()));
        };
    if (is_stiff)
        result.stiff = {.rate = [self](double t, const Vector& y) -> Vector {
                            return self->unit * self->stiff_rate(self->unit * t, y);
                        },
                        .prepare =
                            [self](double, const Vector&, double gamma) {
                                for (Part& part : self->parts)
                                    if (part.resolvent)
                                        part.resolvent->prepare(self->unit * gamma);
                            },
                        .solve = [self](const Vector& b) { return self->solve(b); },
                        .linearity = has_data ? Linearity::affine : Linearity::linear};
    result.progress = [self](double t) {
        if (self->progress)
            self->progress(self->unit * t);
    };
    if (options.event)
        result.event = [self](double t, const Vector& y) {
            const double time = self->unit * t;
            return self->options.event(time, self->forms(time, y));
        };
    return result;
}

std::optional<Fingerprint> Evolution::Equation::fingerprint() const {
    bool has_functions = reaction || options.event;
    for (const Part& part : parts)
        has_functions = has_functions || part.unknown.boundary;
    if (has_functions && options.label.empty())
        return std::nullopt;
    const IntegratorOptions& steps = options.steps;
    Fingerprint result;
    result.add("evolution").add(options.label).add(has_functions);
    result.add(options.integrator).add(options.time).add(steps.most_steps);
    for (const double number : {steps.relative_tolerance, steps.absolute_tolerance.value_or(0),
                                steps.first_step, steps.largest_step, steps.fixed_step})
        result.add(number);
    for (const Part& part : parts) {
        result.add(part.unknown.space).add(part.unknown.start);
        if (part.stiff)
            result.add(part.stiff->fingerprint().value());
        const BoundaryForms data = part.boundary(options.time);
        for (const Vector* given :
             {&data.values, &data.codifferential, &data.flow, &data.derivative_flow})
            result.add(*given);
    }
    if (reaction)
        result.add(rate(options.time, start));
    return result;
}

Evolution::Evolution(std::vector<Unknown> unknowns, Reaction reaction, EvolutionOptions options)
    : equation_(std::make_shared<Equation>()) {
    const double time = options.time;
    equation_->unit = unit_of_time(unknowns, !!reaction);
    integrator_ = make_integrator(options.integrator, in_unit(options.steps, equation_->unit));
    equation_->reaction = std::move(reaction);
    equation_->options = std::move(options);
    for (const Unknown& unknown : unknowns)
        equation_->add(unknown);
    begin(time, equation_->start, {});
}

void Evolution::begin(double time, const Vector& values, const Vector& memory) {
    integrator_->begin(equation_->problem(equation_), time / equation_->unit, values, memory);
}

Arrival Evolution::march(double until, const TimeListener& progress) {
    equation_->progress = progress;
    return integrator_->advance(until / equation_->unit);
}

StepPlan Evolution::plan(const std::vector<double>& times) const {
    const double step = equation_->options.steps.fixed_step;
    if (step == 0)
        return {.limit = "the error allowed in a step",
                .advice = "IntegratorOptions::relative_tolerance changes that"};
    double count = 0, now = time();
    for (const double next : times)
        if (next > now) {
            count += equal_steps(now, next, step).count;
            now = next;
        }
    return {static_cast<std::int64_t>(std::min(count, 1e15)), step, "the wanted accuracy",
            "IntegratorOptions::fixed_step changes that"};
}

double Evolution::time() const {
    return equation_->unit * integrator_->time();
}

std::vector<Cochain> Evolution::forms() const {
    return equation_->forms(time(), integrator_->state());
}

bool Evolution::resumes_anywhere() const {
    return integrator_->traits().resumes_anywhere;
}

std::vector<Vector> Evolution::state() const {
    return {integrator_->state(), integrator_->memory()};
}

void Evolution::resume(double time, const std::vector<Vector>& state) {
    if (state.size() != 2 || state[0].size() != equation_->start.size())
        throw InvalidInput(fmt::format("the state belongs to another evolution: expected {} values "
                                       "and the memory of the integrator",
                                       equation_->start.size()));
    begin(time, state[0], state[1]);
}

std::optional<Fingerprint> Evolution::fingerprint() const {
    return equation_->fingerprint();
}

IntegratorReport Evolution::report() const {
    auto result = integrator_->report();
    result.last_step *= equation_->unit;
    return result;
}

} // namespace polydec
