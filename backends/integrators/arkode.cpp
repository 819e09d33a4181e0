// SPDX-License-Identifier: MIT
#include "backends/component.h"
#include "backends/integrators/sundials.h"

#include <algorithm>
#include <arkode/arkode_arkstep.h>
#include <cmath>
#include <memory>
#include <new>

namespace polydec {

namespace {

struct FreeArkode {
    void operator()(void* memory) const { ARKStepFree(&memory); }
};

class Arkode final : public SundialsIntegrator {
public:
    explicit Arkode(const IntegratorOptions& options) : SundialsIntegrator("arkode", options, 0) {}

    IntegratorTraits traits() const override {
        return {.explicit_order = 4, .implicit_order = 4, .resumes_exactly = false};
    }

protected:
    void create() override;
    void set_options();

    int stop_at(double time) override {
        if (options().fixed_step > 0)
            ARKStepSetFixedStep(memory_.get(), equal_step(time));
        return ARKStepSetStopTime(memory_.get(), time);
    }

    int evolve(double until, double& reached) override {
        return ARKStepEvolve(memory_.get(), until, vector(), &reached, ARK_NORMAL);
    }

    Counts engine_counts() const override {
        Counts result;
        ARKStepGetNumSteps(memory_.get(), &result.steps);
        ARKStepGetLastStep(memory_.get(), &result.last_step);
        long failures = 0;
        ARKStepGetNumErrTestFails(memory_.get(), &result.rejected);
        ARKStepGetNumNonlinSolvConvFails(memory_.get(), &failures);
        result.rejected += failures;
        return result;
    }

    void current(double& time, double& gamma, N_Vector& state) const override {
        ARKStepGetCurrentTime(memory_.get(), &time);
        ARKStepGetCurrentGamma(memory_.get(), &gamma);
        ARKStepGetCurrentState(memory_.get(), &state);
    }

private:
    /// Of steps that end at this time.
    double equal_step(double until) const {
        const double rest = until - time();
        return rest / std::max(1.0, std::ceil(rest / options().fixed_step - 1e-9));
    }

    std::unique_ptr<void, FreeArkode> memory_;
};

void Arkode::create() {
    memory_.reset(ARKStepCreate(problem().rate ? call_rate : nullptr,
                                is_stiff() ? call_stiff_rate : nullptr, time(), vector(),
                                context()));
    if (!memory_)
        throw std::bad_alloc();
    void* const memory = memory_.get();
    ARKStepSetErrHandlerFn(memory, hear, this);
    require(ARKStepSetUserData(memory, this), "setting up");
    require(ARKStepWFtolerances(memory, call_weights), "setting the tolerances");
    set_options();
    if (is_stiff()) {
        require(ARKStepSetLinearSolver(memory, solver(), nullptr), "setting the solver");
        require(ARKStepSetDeduceImplicitRhs(memory, SUNTRUE), "setting the solver");
        if (is_affine())
            require(ARKStepSetLinear(memory, 0), "setting the solver");
    }
    if (has_events())
        require(ARKStepRootInit(memory, 1, call_event), "setting the event");
}

void Arkode::set_options() {
    void* const memory = memory_.get();
    require(ARKStepSetOrder(memory, 4), "setting the order");
    require(ARKStepSetMaxNumSteps(memory, options().most_steps), "setting the options");
    require(ARKStepSetMaxHnilWarns(memory, -1), "setting the options");
    if (options().fixed_step > 0)
        return;
    if (options().first_step > 0)
        require(ARKStepSetInitStep(memory, options().first_step), "setting the options");
    if (options().largest_step > 0)
        require(ARKStepSetMaxStep(memory, options().largest_step), "setting the options");
}

} // namespace

void component::add_arkode(EngineRegistrar& registrar) {
    registrar.add_integrator({.name = "arkode"}, [](const IntegratorOptions& options) {
        return std::make_unique<Arkode>(options);
    });
}

} // namespace polydec
