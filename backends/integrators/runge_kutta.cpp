// SPDX-License-Identifier: MIT
#include "backends/builtin_engines.h"
#include "backends/integrators/additive_table.h"
#include "backends/integrators/equal_steps.h"
#include "base/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace polydec {

namespace {

constexpr double rounding = std::numeric_limits<double>::epsilon();
constexpr double no_number = std::numeric_limits<double>::infinity();

/// Additive Runge-Kutta steps, of lengths that a controller by the last two errors chooses
/// (Gustafsson 1991). With a stiff part the length is kept as long as it may, since another one
/// costs a factorization.
class RungeKutta final : public Integrator {
public:
    /// By one table without a stiff part, and by another with one.
    RungeKutta(const char* name, const IntegratorOptions& options, AdditiveTable plain,
               AdditiveTable stiff)
        : Integrator(name, options), plain_(std::move(plain)), stiff_(std::move(stiff)) {
        if (stiff_.embedded_order == 0 && !is_fixed())
            throw InvalidInput(fmt::format("{}: does not estimate errors, so all steps have one "
                                           "length: it needs IntegratorOptions::fixed_step above 0",
                                           name));
    }

    IntegratorTraits traits() const override {
        return {.explicit_order = plain_.order,
                .implicit_order = stiff_.order,
                .resumes_anywhere = is_fixed()};
    }

    /// First what tells the engine and its steps from others.
    Vector memory() const override {
        Vector result(8 + largest().size());
        result << identity(), wanted_, last_error_, step_, left_, end_, largest();
        return result;
    }

protected:
    void start(const Vector& memory) override {
        table_ = is_stiff() ? &stiff_ : &plain_;
        const auto parts = largest().size();
        const bool goes_on = memory.size() == 8 + parts;
        if (memory.size() != 0 && (!goes_on || !memory.allFinite() ||
                                   memory.head(7).minCoeff() < 0 || memory.head(3) != identity()))
            throw InvalidInput(
                fmt::format("{}: cannot resume from the memory of another "
                            "integrator, or of one with other steps: expected {} "
                            "finite numbers, the first three its orders and "
                            "IntegratorOptions::fixed_step, the next four at least 0",
                            name(), 8 + parts));
        if (goes_on)
            record_largest(memory.tail(parts));
        wanted_ = goes_on ? memory[3] : options().first_step;
        last_error_ = goes_on ? memory[4] : 1;
        step_ = goes_on ? memory[5] : 0;
        left_ = goes_on ? memory[6] : 0;
        end_ = goes_on ? memory[7] : time();
        if (is_fixed())
            wanted_ = options().fixed_step;
        prepared_ = 0;
        was_rejected_ = knows_first_rates_ = false;
        const Eigen::Index stages = table_->stages();
        f_.setZero(state().size(), problem().rate ? stages : 0);
        g_.setZero(state().size(), is_stiff() ? stages : 0);
    }

    Arrival march(double until) override {
        learn_first_rates();
        if (wanted_ == 0)
            wanted_ = first_step(until - time());
        if (until != end_ || !is_fixed())
            left_ = 0;
        end_ = until;
        double before = has_events() ? event(time(), state()) : 0;
        for (Index steps = 0; steps < options().most_steps;) {
            if (left_ == 0) {
                const auto [step, count] = equal_steps(time(), until, wanted_);
                step_ = step;
                left_ = count;
            }
            const double end = left_ == 1 ? until : time() + step_;
            if (end <= time())
                fail("steps have become too short to change the time: the solution may end here, "
                     "or a rate may not be a smooth function of the state");
            Trial trial = take(step_, end);
            if (!(trial.error <= 1)) {
                reject(trial);
                continue;
            }
            if (has_events()) {
                const double after = event(end, trial.state);
                if (before != 0 && (after == 0 || (after > 0) != (before > 0)))
                    return stop_at_event(before, after, std::move(trial.state));
                before = after;
            }
            keep(std::move(trial), end);
            ++steps;
            if (end == until)
                return Arrival::at_time;
        }
        fail(fmt::format(
            "{} steps do not suffice: allow more steps (most_steps) or larger errors; if steps are "
            "short where the solution is smooth, move stiff terms into the stiff part",
            options().most_steps));
    }

private:
    Eigen::Vector3d identity() const {
        return {static_cast<double>(plain_.order), static_cast<double>(stiff_.order),
                options().fixed_step};
    }

    struct Trial {
        Vector state;
        double error; ///< as a part of what is allowed; infinite where there is no such state
    };

    bool is_fixed() const { return options().fixed_step > 0; }

    void learn_first_rates() {
        if (knows_first_rates_)
            return;
        if (problem().rate)
            f_.col(0) = rate(time(), state());
        if (is_stiff() && table_->uses_first_stiff_rate())
            g_.col(0) = stiff_rate(time(), state());
        if (!f_.leftCols(std::min<Eigen::Index>(1, f_.cols())).allFinite() ||
            !g_.leftCols(std::min<Eigen::Index>(1, g_.cols())).allFinite())
            fail_of_rate();
        knows_first_rates_ = true;
    }

    // In which the state changes by a hundredth of its size (Hairer, Norsett, Wanner 1993, II.4).
    double first_step(double span) {
        Vector change = Vector::Zero(state().size());
        if (f_.cols() > 0)
            change += f_.col(0);
        if (g_.cols() > 0)
            change += g_.col(0);
        // what begins at 0 has the size that it grows to
        const Vector here = largest(), next = largest_with(state() + 1e-3 * span * change);
        const Vector allowed = this->allowed(state(), (here.array() > 0).select(here, next));
        const double now = size(state(), allowed), speed = size(change, allowed);
        const bool is_told = now > 1e-5 && speed > 1e-5;
        const double step = is_told ? 0.01 * now / speed : 1e-3 * span;
        const double largest = options().largest_step > 0 ? options().largest_step : span;
        return std::min({step, span, largest});
    }

    Trial take(double step, double end) {
        const double gamma = is_stiff() ? step * table_->implicit_part(1, 1) : 0;
        if (is_stiff() &&
            (gamma != prepared_ || problem().stiff->linearity == Linearity::general)) {
            prepare(time(), state(), gamma);
            prepared_ = gamma;
        }
        for (Eigen::Index i = 1; i < table_->stages(); ++i)
            if (!take_stage(i, step, end))
                return {{}, no_number};
        const bool is_end = table_->ends_at_last_stage(f_.cols() > 0, is_stiff());
        Vector next = is_end ? std::move(stage_) : moved(state(), step, table_->weights);
        if (!next.allFinite())
            return {{}, no_number};
        if (is_fixed())
            return {std::move(next), 0};
        const Vector error = moved(Vector::Zero(next.size()), step, table_->error_weights);
        const Vector larger = state().cwiseAbs().cwiseMax(next.cwiseAbs());
        Vector largest = largest_with(larger);
        if (was_rejected_)
            largest = largest.cwiseMax(ahead_);
        return {std::move(next),
                error.allFinite() ? size(error, allowed(larger, largest)) : no_number};
    }

    /// A state plus the step times the rates, explicit and implicit, with these weights of stages.
    Vector moved(Vector state, double step, const Vector& weights) const {
        for (const DenseMatrix* rates : {&g_, &f_})
            if (rates->cols() > 0)
                state += step * (*rates * weights);
        return state;
    }

    /// False if its rates are not finite or its equation is not solved.
    bool take_stage(Eigen::Index i, double step, double end) {
        const double part = table_->times[i];
        const double time = part == 1 ? end : this->time() + part * step;
        Vector known = before_stage(i, step);
        if (is_stiff()) {
            const double gamma = step * table_->implicit_part(i, i);
            if (!solve_stage(time, gamma, known, stage_))
                return false;
            g_.col(i) = (stage_ - known) / gamma;
        } else {
            stage_ = std::move(known);
        }
        if (!stage_.allFinite())
            return false;
        if (f_.cols() > 0)
            f_.col(i) = rate(time, stage_);
        return f_.cols() == 0 || f_.col(i).allFinite();
    }

    /// Solves Y - gamma g(t, Y) = known by Newton's method, in one step where g is affine.
    bool solve_stage(double time, double gamma, const Vector& known, Vector& state) {
        constexpr int most = 10;
        constexpr double small = 1e-3; // of what a step may be wrong by
        const Linearity linearity = problem().stiff->linearity;
        if (linearity == Linearity::linear) {
            state = solve(known);
            return true;
        }
        state = this->state();
        const Vector allowed = this->allowed(state);
        double last = no_number;
        for (int i = 0; i < most; ++i) {
            const Vector residual = known + gamma * stiff_rate(time, state) - state;
            if (!residual.allFinite())
                return false;
            const Vector change = solve(residual);
            state += change;
            if (linearity == Linearity::affine)
                return true;
            const double now = size(change, allowed);
            if (now <= small)
                return true;
            if (!(now < 2 * last))
                return false;
            last = now;
        }
        return false;
    }

    /// What is known of a stage's state before its own rates are.
    Vector before_stage(Eigen::Index i, double step) const {
        Vector result = state();
        if (f_.cols() > 0)
            result += step * (f_.leftCols(i) * table_->explicit_part.row(i).head(i).transpose());
        if (g_.cols() > 0)
            result += step * (g_.leftCols(i) * table_->implicit_part.row(i).head(i).transpose());
        return result;
    }

    void reject(const Trial& trial) {
        if (is_fixed())
            fail(fmt::format("a step of {:.6g} gives values that are not finite, or its equations "
                             "cannot be solved: use shorter steps",
                             step_));
        ++counts().rejected;
        const double order = table_->embedded_order + 1;
        const double factor =
            std::isfinite(trial.error) ? 0.9 * std::pow(trial.error, -1 / order) : 0.25;
        wanted_ = step_ * std::clamp(factor, 0.2, 0.9);
        if (!was_rejected_)
            ahead_ = largest_with(ahead(time(), state(), step_));
        was_rejected_ = true;
        left_ = 0;
    }

    void keep(Trial trial, double end) {
        accept(end, std::move(trial.state), step_);
        if (!is_fixed()) {
            constexpr double least = 1e-8;
            const double error = std::max(trial.error, least), order = table_->embedded_order + 1;
            const double factor =
                0.9 * std::pow(error, -0.7 / order) * std::pow(last_error_, 0.4 / order);
            last_error_ = error;
            wanted_ = lengthened(std::clamp(factor, 0.2, was_rejected_ ? 1.0 : 5.0));
            was_rejected_ = false;
        }
        left_ = is_fixed() || wanted_ == step_ ? left_ - 1 : 0;
        knows_first_rates_ = !is_stiff() && table_->ends_at_last_stage(true, false);
        if (knows_first_rates_)
            f_.col(0) = f_.col(f_.cols() - 1);
        else
            learn_first_rates();
    }

    /// The steps that are wanted after one, by the factor that its error allows.
    double lengthened(double factor) const {
        constexpr double worth_a_factorization = 1.5, most = 5;
        double result = factor * step_;
        if (is_stiff() && factor >= 1 && factor < worth_a_factorization)
            result = step_;
        else if (factor >= most)
            result = std::max(result, wanted_); // it was short for the sake of the end alone
        return options().largest_step > 0 ? std::min(result, options().largest_step) : result;
    }

    /// Regula falsi (Illinois), with a whole step to each time.
    Arrival stop_at_event(double before, double after, Vector state) {
        double low = 0, high = step_;
        const double closest = 4 * rounding * std::max(std::abs(time()) + step_, step_);
        constexpr int most = 100;
        for (int last = 0, i = 0; high - low > closest && after != 0 && i < most; ++i) {
            double step = low + (high - low) * before / (before - after);
            step = std::clamp(step, low + closest / 2, high - closest / 2);
            Trial trial = take(step, time() + step);
            if (!std::isfinite(trial.error))
                fail("a rate is not finite in the step to an event");
            const double value = event(time() + step, trial.state);
            const bool is_behind = value == 0 || (value > 0) == (after > 0);
            if (is_behind) {
                high = step;
                after = value;
                state = std::move(trial.state);
                before /= last > 0 ? 2 : 1;
            } else {
                low = step;
                before = value;
                after /= last < 0 ? 2 : 1;
            }
            last = is_behind ? 1 : -1;
        }
        accept(time() + high, std::move(state), high);
        left_ = 0;
        was_rejected_ = knows_first_rates_ = false;
        learn_first_rates();
        return Arrival::at_event;
    }

    AdditiveTable plain_, stiff_;
    const AdditiveTable* table_ = nullptr;
    double wanted_ = 0;     ///< length of the steps to come; 0: not known
    double last_error_ = 1; ///< of the last step
    double step_ = 0;       ///< wanted_, shortened so that steps are equal up to the end
    double left_ = 0;       ///< steps of this length up to the end; 0: to be planned
    double end_ = 0;
    bool was_rejected_ = false;
    Vector ahead_;        ///< if so, largest() at the end of that step: rates may jump from 0
    double prepared_ = 0; ///< the gamma that can be solved with
    bool knows_first_rates_ = false;
    DenseMatrix f_, g_; ///< rates, a column for each stage
    Vector stage_;      ///< the state of the last one
};

} // namespace

std::unique_ptr<Integrator> builtin::make_runge_kutta(const IntegratorOptions& options) {
    return std::make_unique<RungeKutta>("runge-kutta", options, dormand_prince(),
                                        kennedy_carpenter());
}

std::unique_ptr<Integrator> builtin::make_backward_euler(const IntegratorOptions& options) {
    return std::make_unique<RungeKutta>("backward-euler", options, polydec::backward_euler(),
                                        polydec::backward_euler());
}

std::unique_ptr<Integrator> builtin::make_implicit_midpoint(const IntegratorOptions& options) {
    return std::make_unique<RungeKutta>("implicit-midpoint", options, polydec::implicit_midpoint(),
                                        polydec::implicit_midpoint());
}

} // namespace polydec
