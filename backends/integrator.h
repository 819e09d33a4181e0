// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <functional>
#include <optional>
#include <string>

namespace polydec {

/// The rate of change of a state at a time: as many entries as the state.
using Rate = std::function<Vector(double time, const Vector& state)>;

/// Whether a rate is a matrix times the state that never changes, the same and a term that the time
/// alone changes, or anything.
enum class Linearity { linear, affine, general };

/// The stiff part g(t, y) of a rate, and how to solve with its derivative g' by y, so that steps
/// need not be as short as the fastest decay.
struct StiffPart {
    Rate rate = {};

    /// Gets ready for solving with this gamma > 0 where g' is that at this time and state: by a
    /// factorization, say. Called as seldom as can be.
    std::function<void(double time, const Vector& state, double gamma)> prepare = {};

    /// x with x - gamma g' x = b, for what was prepared last.
    std::function<Vector(const Vector& b)> solve = {};

    Linearity linearity = Linearity::affine;
};

/// y' = f(t, y) + g(t, y), of which one may be missing. What the functions throw passes through the
/// integrator that calls them.
struct InitialValueProblem {
    Rate rate = {};                      ///< f, which is not stiff
    std::optional<StiffPart> stiff = {}; ///< g

    /// A march stops where this goes through 0.
    std::function<double(double time, const Vector& state)> event = {};

    /// Called with the time at each evaluation of a rate and at each solve. An exception from it
    /// ends the march.
    std::function<void(double time)> progress = {};

    /// What an entry of the state is measured in: the absolute tolerance is multiplied by it, as
    /// values of forms are by the volumes of cells. Empty: 1.
    Vector scale = {};
};

struct IntegratorOptions {
    /// A step may be wrong by relative |y_i| + absolute scale_i in each entry, in the mean of
    /// squares.
    double relative_tolerance = 1e-5;
    double absolute_tolerance = 1e-8;
    double first_step = 0;   ///< 0: chosen
    double largest_step = 0; ///< 0: any
    /// Steps of this length, made equal between the times that are marched to, instead of those
    /// that the tolerances ask for; 0: the latter.
    double fixed_step = 0;
    Index most_steps = 1'000'000; ///< in one march
};

/// What an integrator can do; asking for more is refused with InvalidInput.
struct IntegratorTraits {
    int explicit_order = 0; ///< of accuracy, where nothing is stiff; 0: varies
    int implicit_order = 0; ///< with a stiff part
    bool has_fixed_steps = true;
    bool resumes_exactly = true;   ///< memory() makes a march go on in the same bits
    bool resumes_anywhere = false; ///< and does so between the times that are marched to
};

/// What it took, since begin().
struct IntegratorReport {
    std::string engine = {};
    Index steps = 0;
    Index rejected = 0;          ///< steps tried, and taken again shorter
    Index evaluations = 0;       ///< of the rate f
    Index stiff_evaluations = 0; ///< of g
    Index preparations = 0;      ///< for solving with a gamma
    Index solves = 0;
    double last_step = 0;
};

/// Where a march has ended.
enum class Arrival { at_time, at_event };

/// Solves initial value problems. One interface for every engine. An object is used by one thread
/// at a time; two objects are independent.
class Integrator {
public:
    virtual ~Integrator() = default;
    Integrator(const Integrator&) = delete;
    Integrator& operator=(const Integrator&) = delete;

    const std::string& name() const { return report_.engine; }
    virtual IntegratorTraits traits() const = 0;

    /// Begins with this state at this time. With what memory() was there and then, goes on with
    /// the same steps. Throws InvalidInput for a problem without a rate, a stiff part without one
    /// of its functions, scales other than one above 0 for each entry, what is not finite, options
    /// that the engine has not, and memory that is not of this engine.
    void begin(InitialValueProblem problem, double time, Vector state, const Vector& memory = {});

    /// Marches to this time, and there exactly, or to the first event: to the end of the smallest
    /// interval of times that it is known to be in. An event at the beginning does not count.
    /// Throws InvalidInput for a time before now or without begin(); SolverFailure, naming the
    /// time, where a rate is not finite however short the step, where steps become too short to
    /// change the time, and after most_steps. Then time() and state() are those after a good step:
    /// the last one, or, where an engine does not tell, the last one before this march.
    Arrival advance(double time);

    double time() const { return time_; }
    const Vector& state() const { return state_; }
    const IntegratorReport& report() const { return report_; }

    /// What begin() needs beside time and state to go on in the same bits; empty if it needs
    /// nothing, or cannot.
    virtual Vector memory() const { return {}; }

protected:
    /// Throws InvalidInput for options that make no sense.
    Integrator(const std::string& name, const IntegratorOptions& options);

    /// Begins; for a state with entries, after all has been checked.
    virtual void start(const Vector& memory) = 0;

    /// Marches to a time behind now, as advance() says; keeps time and state by accept().
    virtual Arrival march(double until) = 0;

    const IntegratorOptions& options() const { return options_; }
    const InitialValueProblem& problem() const { return problem_; }
    bool is_stiff() const { return problem_.stiff.has_value(); }
    bool has_events() const { return static_cast<bool>(problem_.event); }

    /// Rates and solutions, counted, of the right size; maybe not finite.
    Vector rate(double time, const Vector& state);
    Vector stiff_rate(double time, const Vector& state);
    void prepare(double time, const Vector& state, double gamma);
    Vector solve(const Vector& b);

    /// Throws SolverFailure unless it is finite.
    double event(double time, const Vector& state) const;

    /// The steps of the end of a march, which is no failure of a shorter one.
    void accept(double time, Vector state, double step);
    IntegratorReport& counts() { return report_; }

    /// How much an error is of what the tolerances allow, beside states: 1 is just allowed.
    Vector allowed(const Vector& state) const;
    double size(const Vector& error, const Vector& allowed) const;

    /// Throws SolverFailure, naming the engine and the time.
    [[noreturn]] void fail(const std::string& reason) const;

    /// The same, naming the first entry of the rate that is not finite now.
    [[noreturn]] void fail_of_rate();

private:
    void check(const InitialValueProblem& problem, double time, const Vector& state) const;
    Vector sized(Vector rate, const char* what) const;

    IntegratorOptions options_;
    InitialValueProblem problem_;
    bool has_begun_ = false;
    double time_ = 0;
    Vector state_;
    IntegratorReport report_;
};

} // namespace polydec
