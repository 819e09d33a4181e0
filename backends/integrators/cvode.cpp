// SPDX-License-Identifier: MIT
#include "backends/component.h"
#include "backends/integrators/sundials.h"

#include <algorithm>
#include <cmath>
#include <cvode/cvode.h>
#include <limits>
#include <memory>
#include <new>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

namespace polydec {

namespace {

struct FreeCvode {
    void operator()(void* memory) const { CVodeFree(&memory); }
};
struct FreeIteration {
    void operator()(SUNNonlinearSolver solver) const { SUNNonlinSolFree(solver); }
};

/// Solves for what is not stiff as well, with the derivative of the stiff part alone.
class Cvode final : public SundialsIntegrator {
public:
    explicit Cvode(const IntegratorOptions& options) : SundialsIntegrator("cvode", options, 0.2) {}

    IntegratorTraits traits() const override {
        return {.has_fixed_steps = false, .resumes_exactly = false};
    }

protected:
    void create() override;
    void set_options();

    int stop_at(double until) override {
        // Steps that no longer change the time would be taken until most_steps are used up.
        const double least = 4 * std::numeric_limits<double>::epsilon() *
                             std::max(std::abs(time()), std::abs(until));
        if (const int answer = CVodeSetMinStep(memory_.get(), least); answer != 0)
            return answer;
        return CVodeSetStopTime(memory_.get(), until);
    }

    int evolve(double until, double& reached) override {
        return CVode(memory_.get(), until, vector(), &reached, CV_NORMAL);
    }

    Counts engine_counts() const override {
        Counts result;
        CVodeGetNumSteps(memory_.get(), &result.steps);
        CVodeGetLastStep(memory_.get(), &result.last_step);
        long failures = 0;
        CVodeGetNumErrTestFails(memory_.get(), &result.rejected);
        CVodeGetNumNonlinSolvConvFails(memory_.get(), &failures);
        result.rejected += failures;
        return result;
    }

    void current(double& time, double& gamma, N_Vector& state) const override {
        CVodeGetCurrentTime(memory_.get(), &time);
        CVodeGetCurrentGamma(memory_.get(), &gamma);
        CVodeGetCurrentState(memory_.get(), &state);
    }

private:
    std::unique_ptr<std::remove_pointer_t<SUNNonlinearSolver>, FreeIteration> iteration_;
    std::unique_ptr<void, FreeCvode> memory_;
};

void Cvode::create() {
    memory_.reset(CVodeCreate(is_stiff() ? CV_BDF : CV_ADAMS, context()));
    if (!memory_)
        throw std::bad_alloc();
    void* const memory = memory_.get();
    CVodeSetErrHandlerFn(memory, hear, this);
    require(CVodeInit(memory, call_all_rates, time(), vector()), "setting up");
    require(CVodeSetUserData(memory, this), "setting up");
    require(CVodeWFtolerances(memory, call_weights), "setting the tolerances");
    set_options();
    if (is_stiff())
        require(CVodeSetLinearSolver(memory, solver(), nullptr), "setting the solver");
    else {
        iteration_.reset(SUNNonlinSol_FixedPoint(vector(), 0, context()));
        if (!iteration_)
            throw std::bad_alloc();
        require(CVodeSetNonlinearSolver(memory, iteration_.get()), "setting the iteration");
    }
    if (has_events())
        require(CVodeRootInit(memory, 1, call_event), "setting the event");
}

void Cvode::set_options() {
    void* const memory = memory_.get();
    require(CVodeSetMaxNumSteps(memory, options().most_steps), "setting the options");
    require(CVodeSetMaxHnilWarns(memory, -1), "setting the options");
    if (options().first_step > 0)
        require(CVodeSetInitStep(memory, options().first_step), "setting the options");
    if (options().largest_step > 0)
        require(CVodeSetMaxStep(memory, options().largest_step), "setting the options");
}

} // namespace

void component::add_cvode(EngineRegistrar& registrar) {
    registrar.add_integrator({.name = "cvode"}, [](const IntegratorOptions& options) {
        return std::make_unique<Cvode>(options);
    });
}

} // namespace polydec
