// SPDX-License-Identifier: MIT
#include "solvers/evolution.h"

#include "backends/registry.h"
#include "base/errors.h"
#include "meshes/unit_of_length.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace polydec {

namespace {

std::shared_ptr<Diffusion> stiff_part(const Cells& cells, const Unknown& unknown,
                                      const std::string& linear_solver) {
    if (unknown.stiff || unknown.diffusion == 0)
        return unknown.stiff;
    const auto& [side, degree, values] = unknown.start;
    const DiffusionOptions options{.coefficient = unknown.diffusion,
                                   .conditions = unknown.conditions,
                                   .linear_solver = linear_solver};
    return std::make_shared<Diffusion>(cells, side, degree, options);
}

/// Sizes of cells, by which values are coefficients; where one is nothing, the mean.
Vector sizes_of_cells(const CellVolumes& volumes, Side side, int degree) {
    Vector sizes =
        side == Side::primal ? volumes.primal(degree) : volumes.dual(volumes.dimension() - degree);
    sizes = sizes.cwiseAbs();
    const double mean = sizes.size() > 0 ? sizes.mean() : 0;
    const double least = 1e-3;
    return mean > 0 ? Vector(sizes.cwiseMax(least * mean)) : Vector::Ones(sizes.size());
}

/// The time to measure in, so that rates of diffusion are ordinary numbers: 1 where the largest
/// coefficient in the unit of the mesh is between 2^-80 and 2^80, else the power of two by which it
/// becomes 1 to 2.
double unit_of_time(const Cells& cells, const std::vector<Unknown>& unknowns) {
    constexpr int moderate = 80;
    double largest = 0;
    for (const Unknown& unknown : unknowns)
        largest = std::max(largest, unknown.diffusion);
    if (!(largest > 0) || !std::isfinite(largest))
        return 1;
    const int exponent = std::ilogb(largest) - 2 * std::ilogb(cells.unit());
    return std::abs(exponent) <= moderate ? 1 : std::ldexp(1.0, -exponent);
}

/// All times in this unit.
IntegratorOptions in_unit(IntegratorOptions steps, double unit) {
    for (double* time : {&steps.first_step, &steps.largest_step, &steps.fixed_step})
        *time /= unit;
    return steps;
}

} // namespace

/// The unknowns, and how their values are one vector: those of the cells that nothing fixes, one
/// unknown behind the other. An integrator has times in a unit, all else has those of the caller.
struct Evolution::Equation {
    struct Part {
        Unknown unknown;
        std::shared_ptr<Diffusion> stiff; ///< or null
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
    std::function<Fingerprint()> cells;
    Vector start, scale;

    void add(const Cells& cells, const Unknown& unknown);
    std::vector<Cochain> forms(double time, const Vector& values) const;
    Vector rate(double time, const Vector& values) const;
    Vector stiff_rate(double time, const Vector& values) const;
    Vector solve(const Vector& b) const;
    InitialValueProblem problem(const std::shared_ptr<Equation>& self) const;
    std::optional<Fingerprint> fingerprint() const;
};

void Evolution::Equation::add(const Cells& cells, const Unknown& unknown) {
    const auto& [side, degree, values] = unknown.start;
    const std::size_t number = parts.size();
    check(cells.complex(), unknown.start);
    auto stiff = stiff_part(cells, unknown, options.linear_solver);
    if (stiff && (stiff->side() != side || stiff->degree() != degree))
        throw InvalidInput(fmt::format("unknown {}: its stiff part is for {} {}-forms, and it is a "
                                       "{} {}-form",
                                       number, name(stiff->side()), stiff->degree(), name(side),
                                       degree));
    if (unknown.boundary && !stiff)
        throw InvalidInput(fmt::format("unknown {}: data on the boundary are given, and no "
                                       "diffusion that would take them in",
                                       number));
    std::vector<Index> kept(values.size());
    std::iota(kept.begin(), kept.end(), 0);
    if (stiff)
        kept = stiff->kept();
    const Vector sizes = in_input_units(sizes_of_cells(cells.stars().volumes(), side, degree),
                                        cells.unit(), degree, "sizes of cells");
    const auto first = static_cast<Index>(start.size());
    start.conservativeResize(first + kept.size());
    scale.conservativeResize(first + kept.size());
    scale.tail(kept.size()) = sizes(kept);
    parts.push_back({unknown, std::move(stiff), std::move(kept), first});
    const Part& part = parts.back();
    start.tail(part.size()) =
        part.stiff ? part.stiff->values_of(values, part.boundary(options.time)) : values;
}

std::vector<Cochain> Evolution::Equation::forms(double time, const Vector& values) const {
    std::vector<Cochain> result;
    for (const Part& part : parts) {
        const auto& [side, degree, start_values] = part.unknown.start;
        const Vector now = part.of(values);
        result.push_back(
            {side, degree, part.stiff ? part.stiff->form_of(now, part.boundary(time)) : now});
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
        const auto expected = part.unknown.start.values.size();
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
            result.segment(part.first, part.size()) = part.stiff->solve(part.of(b));
    return result;
}

InitialValueProblem Evolution::Equation::problem(const std::shared_ptr<Equation>& self) const {
    InitialValueProblem result{.scale = scale};
    const bool is_stiff =
        std::any_of(parts.begin(), parts.end(), [](const Part& part) { return !!part.stiff; });
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
                                for (const Part& part : self->parts)
                                    if (part.stiff)
                                        part.stiff->prepare(self->unit * gamma);
                            },
                        .solve = [self](const Vector& b) { return self->solve(b); }};
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
    Fingerprint result = cells();
    result.add("evolution").add(options.label).add(has_functions);
    result.add(options.integrator).add(options.time).add(steps.most_steps);
    for (const double number : {steps.relative_tolerance, steps.absolute_tolerance,
                                steps.first_step, steps.largest_step, steps.fixed_step})
        result.add(number);
    for (const Part& part : parts) {
        const auto& [side, degree, values] = part.unknown.start;
        result.add(side).add(degree).add(values);
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

double largest_coefficient(const Cells& cells, const Cochain& form) {
    check(cells.complex(), form);
    if (form.values.size() == 0)
        return 0;
    const Vector sizes = sizes_of_cells(cells.stars().volumes(), form.side, form.degree);
    const Vector coefficients = in_input_units(Vector(form.values.cwiseQuotient(sizes)),
                                               cells.unit(), -form.degree, "coefficients");
    return coefficients.cwiseAbs().maxCoeff();
}

Evolution::Evolution(const Cells& cells, std::vector<Unknown> unknowns, Reaction reaction,
                     EvolutionOptions options)
    : equation_(std::make_shared<Equation>()) {
    const double time = options.time;
    equation_->unit = unit_of_time(cells, unknowns);
    integrator_ = make_integrator(options.integrator, in_unit(options.steps, equation_->unit));
    equation_->reaction = std::move(reaction);
    equation_->options = std::move(options);
    equation_->cells = [cells] { return Fingerprint().add(cells); };
    for (const Unknown& unknown : unknowns)
        equation_->add(cells, unknown);
    begin(time, equation_->start, {});
}

void Evolution::begin(double time, const Vector& values, const Vector& memory) {
    integrator_->begin(equation_->problem(equation_), time / equation_->unit, values, memory);
}

Arrival Evolution::march(double until, const TimeListener& progress) {
    equation_->progress = progress;
    return integrator_->advance(until / equation_->unit);
}

double Evolution::time() const {
    return equation_->unit * integrator_->time();
}

std::vector<Cochain> Evolution::forms() const {
    return equation_->forms(time(), integrator_->state());
}

std::vector<Vector> Evolution::state() const {
    return {integrator_->state(), integrator_->memory()};
}

void Evolution::resume(double time, const std::vector<Vector>& state) {
    if (state.size() != 2 || state[0].size() != equation_->start.size())
        throw InvalidInput(fmt::format("a state of another evolution is given: expected {} values "
                                       "and the integrator's memory",
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
