// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace polydec {

/// The rate of change of a state at a time: one entry per entry of the state.
using Rate = std::function<Vector(double time, const Vector& state)>;

/// Form of a rate: linear, a constant matrix times the state; affine, the same plus a term that
/// depends on time alone; general, any function.
enum class Linearity { linear, affine, general };

/// The stiff part g(t, y) of a rate, with a solver for its derivative g' by y, so that the fastest
/// decay does not limit the steps.
struct StiffPart {
    Rate rate = {};

    /// Prepares solves with this gamma > 0 and g' at this time and state, e.g. by a factorization.
    /// Called as rarely as possible.
    std::function<void(double time, const Vector& state, double gamma)> prepare = {};

    /// Solves x - gamma g' x = b, with the last preparation.
    std::function<Vector(const Vector& b)> solve = {};

    Linearity linearity = Linearity::affine;
};

/// The problem y' = f(t, y) + g(t, y); f or g may be missing. Exceptions from the functions pass
/// through the integrator.
struct InitialValueProblem {
    Rate rate = {};                      ///< f, the non-stiff part
    std::optional<StiffPart> stiff = {}; ///< g

    /// A march stops at a zero of this function.
    std::function<double(double time, const Vector& state)> event = {};

    /// Called with the time at each evaluation of a rate and at each solve. An exception from it
    /// ends the march.
    std::function<void(double time)> progress = {};

    /// The scale of each entry of the state, which multiplies the absolute tolerance; for values of
    /// forms, the volumes of cells. Empty: 1.
    Vector scale = {};

    /// The state in parts with units of their own: the number of entries of each. Empty: one part.
    std::vector<Index> parts = {};
};

struct IntegratorOptions {
    /// The error of a step may be relative |y_i| + absolute scale_i in each entry, in the root mean
    /// square.
    double relative_tolerance = 1e-5;
    /// None: a thousandth of the relative one, times the largest |y_i| / scale_i so far in the same
    /// part of the state. So the steps of a linear problem do not depend on the unit of its values.
    std::optional<double> absolute_tolerance = {};
    double first_step = 0;   ///< at most largest_step; 0: automatic
    double largest_step = 0; ///< 0: no limit
    /// Steps of this length, adjusted to equal parts between the end times of marches; 0: the
    /// tolerances determine the steps.
    double fixed_step = 0;
    Index most_steps = 1'000'000; ///< in one march
};

/// The capabilities of an integrator; more is an InvalidInput.
struct IntegratorTraits {
    int explicit_order = 0; ///< of accuracy, for non-stiff problems; 0: varies
    int implicit_order = 0; ///< with a stiff part
    bool has_fixed_steps = true;
    bool resumes_exactly = true;   ///< with memory(), a march resumes bit for bit
    bool resumes_anywhere = false; ///< also between the end times of marches
};

/// Work counts since begin().
struct IntegratorReport {
    std::string engine = {};
    Index steps = 0;
    Index rejected = 0;          ///< steps repeated with a shorter length
    Index evaluations = 0;       ///< of the rate f
    Index stiff_evaluations = 0; ///< of g
    Index preparations = 0;      ///< for solves with a gamma
    Index solves = 0;
    double last_step = 0;
};

/// The reason why a march ended.
enum class Arrival { at_time, at_event };

/// Solves initial value problems: one interface for every engine. Use an object from one thread at
/// a time; two objects are independent.
class Integrator {
public:
    virtual ~Integrator() = default;
    Integrator(const Integrator&) = delete;
    Integrator& operator=(const Integrator&) = delete;

    const std::string& name() const { return report_.engine; }
    virtual IntegratorTraits traits() const = 0;

    /// Starts from this state at this time; with the memory() from then, resumes with the same
    /// steps. Throws InvalidInput for a problem without a rate, a stiff part with a missing
    /// function, scales that are not one positive number per entry, parts that do not add up to
    /// the state, values that are not finite, options that the engine does not support, and memory
    /// from another engine.
    void begin(InitialValueProblem problem, double time, Vector state, const Vector& memory = {});

    /// Marches to exactly this time, or to the first event: to the end of the smallest known time
    /// interval that contains it. An event at the beginning does not count. Throws InvalidInput for
    /// a time in the past or without begin(); SolverFailure, naming the time, if a rate is not
    /// finite however short the step, if steps become too short to change the time, and after
    /// most_steps. Then time() and state() are those after the last completed step.
    Arrival advance(double time);

    double time() const { return time_; }
    const Vector& state() const { return state_; }
    const IntegratorReport& report() const { return report_; }

    /// The input of begin(), besides time and state, that resumes bit for bit; empty if the engine
    /// needs none, or cannot resume.
    virtual Vector memory() const { return {}; }

protected:
    /// Throws InvalidInput for invalid options.
    Integrator(const std::string& name, const IntegratorOptions& options);

    /// Starts, with a nonempty state, after all checks.
    virtual void start(const Vector& memory) = 0;

    /// Marches to a later time, as in advance(); updates time and state by accept().
    virtual Arrival march(double until) = 0;

    const IntegratorOptions& options() const { return options_; }
    const InitialValueProblem& problem() const { return problem_; }
    bool is_stiff() const { return problem_.stiff.has_value(); }
    bool has_events() const { return static_cast<bool>(problem_.event); }

    /// Counted rates and solutions, of the right size; possibly not finite.
    Vector rate(double time, const Vector& state);
    Vector stiff_rate(double time, const Vector& state);
    void prepare(double time, const Vector& state, double gamma);
    Vector solve(const Vector& b);

    /// Throws SolverFailure if the value is not finite.
    double event(double time, const Vector& state) const;

    /// The state after a step of Euler's method, with the stiff part as last prepared: the size of
    /// what is to come. The given state where that is not finite.
    Vector ahead(double time, const Vector& state, double step);

    /// Records an accepted step: the time and state at its end, and its length.
    void accept(double time, Vector state, double step);
    IntegratorReport& counts() { return report_; }

    /// The largest |y_i| / scale_i of each part: in the states recorded or resumed from so far, and
    /// in those and this one.
    const Vector& largest() const { return largest_; }
    Vector largest_with(const Vector& state) const;
    void record_largest(const Vector& largest) { largest_ = largest; }

    /// The allowed errors at a state, with these largest coefficients, and the norm of an error
    /// relative to them: 1 is just allowed. A part that is still 0 counts as the largest other one.
    Vector allowed(const Vector& state, const Vector& largest) const;
    Vector allowed(const Vector& state) const { return allowed(state, largest_with(state)); }
    double size(const Vector& error, const Vector& allowed) const;

    /// Throws SolverFailure, naming the engine and the time.
    [[noreturn]] void fail(const std::string& reason) const;

    /// The same, naming the first non-finite entry of the current rate.
    [[noreturn]] void fail_of_rate();

private:
    void check(const InitialValueProblem& problem, double time, const Vector& state) const;
    Vector sized(Vector rate, const char* what) const;

    IntegratorOptions options_;
    InitialValueProblem problem_;
    bool has_begun_ = false;
    double time_ = 0;
    Vector state_, largest_;
    IntegratorReport report_;
};

} // namespace polydec
