// SPDX-License-Identifier: MIT
#include "backends/component.h"
#include "backends/integrator.h"
#include "base/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cvode/cvode.h>
#include <exception>
#include <limits>
#include <memory>
#include <new>
#include <nvector/nvector_serial.h>
#include <string>
#include <sundials/sundials_context.h>
#include <sundials/sundials_linearsolver.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>
#include <type_traits>
#include <utility>

namespace polydec {

namespace {

// Where gammas are equal but for rounding.
constexpr double rounding = 1e-12;

// How far the gamma of a factorization may be off: Newton's method does the rest.
constexpr double gamma_may_be_off = 0.2;

constexpr int recoverable = 1, unrecoverable = -1;

template <auto free_it>
struct FreeBy {
    template <typename Handle>
    void operator()(Handle* handle) const {
        free_it(handle);
    }
};
template <typename Handle, auto free_it>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, FreeBy<free_it>>;
void free_context(SUNContext context) {
    SUNContext_Free(&context);
}
void free_memory(void* memory) {
    CVodeFree(&memory);
}

Eigen::Map<Eigen::VectorXd> entries(N_Vector vector) {
    return {N_VGetArrayPointer(vector), static_cast<Eigen::Index>(N_VGetLength(vector))};
}

SUNLinearSolver_Type matrix_embedded(SUNLinearSolver) {
    return SUNLINEARSOLVER_MATRIX_EMBEDDED;
}

/// Our functions as those of CVODE, and its answers as ours; nothing of C++ is thrown through its
/// code. Solves for what is not stiff as well, with the derivative of the stiff part alone.
class Cvode final : public Integrator {
public:
    explicit Cvode(const IntegratorOptions& options) : Integrator("cvode", options) {
        SUNContext context = nullptr;
        if (SUNContext_Create(nullptr, &context) != 0)
            throw std::bad_alloc();
        context_.reset(context);
    }

    IntegratorTraits traits() const override {
        return {.has_fixed_steps = false, .resumes_exactly = false};
    }

protected:
    void start(const Vector& memory) override {
        if (memory.size() != 0)
            throw InvalidInput(name() + ": cannot resume from a memory: expected none");
        vector_.reset(N_VNew_Serial(state().size(), context_.get()));
        solver_.reset(SUNLinSolNewEmpty(context_.get()));
        if (!vector_ || !solver_)
            throw std::bad_alloc();
        entries(vector_.get()) = state();
        solver_->content = this;
        solver_->ops->gettype = matrix_embedded;
        solver_->ops->solve = call_solve;
        prepared_ = 0;
        heard_.clear();
        thrown_ = nullptr;
        is_finite_ = true;
        create();
    }

    Arrival march(double until) override {
        until_ = until;
        require(stop_at(until), "setting the end");
        double reached = time(), last_step = 0;
        const int answer = CVode(memory_.get(), until, vector_.get(), &reached, CV_NORMAL);
        CVodeGetLastStep(memory_.get(), &last_step);
        if (answer == CV_RTFUNC_FAIL) { // it leaves another state than that of the last step
            CVodeGetCurrentTime(memory_.get(), &reached);
            CVodeGetDky(memory_.get(), reached, 0, vector_.get());
        }
        const bool at_event = answer == CV_ROOT_RETURN;
        accept(answer < 0 || at_event ? reached : until, entries(vector_.get()), last_step);
        count();
        require(answer, "marching");
        return at_event ? Arrival::at_event : Arrival::at_time;
    }

private:
    void create() {
        memory_.reset(CVodeCreate(is_stiff() ? CV_BDF : CV_ADAMS, context_.get()));
        if (!memory_)
            throw std::bad_alloc();
        void* const memory = memory_.get();
        CVodeSetErrHandlerFn(memory, hear, this);
        require(CVodeInit(memory, call_rates, time(), vector_.get()), "setting up");
        require(CVodeSetUserData(memory, this), "setting up");
        require(CVodeWFtolerances(memory, call_weights), "setting the tolerances");
        set_options();
        if (is_stiff())
            require(CVodeSetLinearSolver(memory, solver_.get(), nullptr), "setting the solver");
        else {
            iteration_.reset(SUNNonlinSol_FixedPoint(vector_.get(), 0, context_.get()));
            if (!iteration_)
                throw std::bad_alloc();
            require(CVodeSetNonlinearSolver(memory, iteration_.get()), "setting the iteration");
        }
        if (has_events())
            require(CVodeRootInit(memory, 1, call_event), "setting the event");
    }

    void set_options() {
        void* const memory = memory_.get();
        require(CVodeSetMaxNumSteps(memory, options().most_steps), "setting the options");
        require(CVodeSetMaxHnilWarns(memory, -1), "setting the options");
        if (options().first_step > 0)
            require(CVodeSetInitStep(memory, options().first_step), "setting the options");
        if (options().largest_step > 0)
            require(CVodeSetMaxStep(memory, options().largest_step), "setting the options");
    }

    int stop_at(double until) {
        // Steps that no longer change the time would be taken until most_steps are used up.
        const double least = 4 * std::numeric_limits<double>::epsilon() *
                             std::max(std::abs(time()), std::abs(until));
        if (const int answer = CVodeSetMinStep(memory_.get(), least); answer != 0)
            return answer;
        return CVodeSetStopTime(memory_.get(), until);
    }

    void count() {
        long steps = 0, rejected = 0, failures = 0;
        CVodeGetNumSteps(memory_.get(), &steps);
        CVodeGetNumErrTestFails(memory_.get(), &rejected);
        CVodeGetNumNonlinSolvConvFails(memory_.get(), &failures);
        counts().steps = static_cast<Index>(steps);
        counts().rejected = static_cast<Index>(rejected + failures);
    }

    /// Throws what an answer below 0 says.
    void require(int answer, const char* step) {
        if (thrown_)
            std::rethrow_exception(std::exchange(thrown_, nullptr));
        if (answer >= 0)
            return;
        if ((answer == CV_CONV_FAILURE && !is_finite_) || answer == CV_RHSFUNC_FAIL ||
            answer == CV_FIRST_RHSFUNC_ERR || answer == CV_REPTD_RHSFUNC_ERR)
            fail_of_rate();
        if (answer == CV_TOO_MUCH_WORK)
            fail(fmt::format(
                "{} steps do not suffice: allow more steps (most_steps) or larger errors; if steps "
                "are short where the solution is smooth, move stiff terms into the stiff part",
                options().most_steps));
        fail(
            fmt::format("{}: {}", step, heard_.empty() ? fmt::format("error {}", answer) : heard_));
    }

    static int call_rates(double time, N_Vector state, N_Vector result, void* self) {
        return guarded(self, [&](Cvode& integrator) {
            Vector sum = Vector::Zero(entries(state).size());
            if (integrator.problem().rate)
                sum += integrator.rate(time, entries(state));
            if (integrator.is_stiff())
                sum += integrator.stiff_rate(time, entries(state));
            return integrator.write(sum, result);
        });
    }

    static int call_event(double time, N_Vector state, double* result, void* self) {
        return guarded(self, [&](Cvode& integrator) {
            *result = integrator.event(time, entries(state));
            return 0;
        });
    }

    static int call_weights(N_Vector state, N_Vector weights, void* self) {
        return guarded(self, [&](Cvode& integrator) {
            const Vector now = entries(state);
            integrator.record_largest(integrator.largest_with(now));
            Vector largest = integrator.largest();
            if (largest.isZero(0))
                largest = integrator.largest_with(integrator.ahead_of(now));
            entries(weights) = integrator.allowed(now, largest).cwiseInverse();
            return 0;
        });
    }

    static int call_solve(SUNLinearSolver solver, SUNMatrix, N_Vector x, N_Vector b, double) {
        return guarded(solver->content, [&](Cvode& integrator) {
            return integrator.write(integrator.solve_with_current(entries(b)), x);
        });
    }

    static void hear(int code, const char*, const char*, char* text, void* self) {
        if (code < 0)
            static_cast<Cvode*>(self)->heard_ = text;
    }

    /// The size of what comes after a state that is 0: CVODE weighs errors before a step.
    Vector ahead_of(const Vector& state) {
        double time = 0, step = 0;
        CVodeGetCurrentTime(memory_.get(), &time);
        CVodeGetCurrentStep(memory_.get(), &step);
        const double rest = until_ - time;
        step = std::min(step > 0 ? step : 1e-3 * rest, rest);
        if (!(step > 0))
            return state;
        if (is_stiff()) {
            prepare(time, state, step);
            prepared_ = step;
            prepared_time_ = time;
        }
        return ahead(time, state, step);
    }

    Vector solve_with_current(const Vector& b) {
        double time = 0, gamma = 0;
        N_Vector state = nullptr;
        CVodeGetCurrentTime(memory_.get(), &time);
        CVodeGetCurrentGamma(memory_.get(), &gamma);
        CVodeGetCurrentState(memory_.get(), &state);
        const bool is_affine = problem().stiff->linearity == Linearity::affine;
        const bool is_elsewhere = !is_affine && time != prepared_time_;
        if (is_elsewhere || !(std::abs(gamma / prepared_ - 1) <= gamma_may_be_off)) {
            prepare(time, entries(state), gamma);
            prepared_ = gamma;
            prepared_time_ = time;
        }
        // a solution with another gamma is too long or too short for what decays fast
        const double excess =
            std::abs(gamma / prepared_ - 1) <= rounding ? 1 : 2 / (1 + gamma / prepared_);
        return excess * solve(b);
    }

    int write(const Vector& values, N_Vector result) {
        entries(result) = values;
        is_finite_ = values.allFinite();
        return is_finite_ ? 0 : recoverable;
    }

    template <typename Work>
    static int guarded(void* self, Work work) {
        auto& integrator = *static_cast<Cvode*>(self);
        try {
            return work(integrator);
        } catch (...) {
            integrator.thrown_ = std::current_exception();
            return unrecoverable;
        }
    }

    Owned<SUNContext, free_context> context_;
    Owned<N_Vector, N_VDestroy> vector_; ///< of the state; CVODE's own copy is its own
    Owned<SUNLinearSolver, SUNLinSolFreeEmpty> solver_;
    Owned<SUNNonlinearSolver, SUNNonlinSolFree> iteration_;
    std::unique_ptr<void, FreeBy<free_memory>> memory_;
    double prepared_ = 0; ///< the gamma that can be solved with
    double prepared_time_ = 0;
    double until_ = 0;      ///< the end of the march
    bool is_finite_ = true; ///< what CVODE was given last
    std::string heard_;     ///< what it said last
    std::exception_ptr thrown_;
};

} // namespace

void component::add_cvode(EngineRegistrar& registrar) {
    registrar.add({.name = "cvode"}, [](const IntegratorOptions& options) {
        return std::make_unique<Cvode>(options);
    });
}

} // namespace polydec
