// SPDX-License-Identifier: MIT
#include "backends/integrators/sundials.h"

#include "base/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <new>
#include <nvector/nvector_serial.h>
#include <utility>

namespace polydec {

namespace {

// Where gammas are equal but for rounding.
constexpr double rounding = 1e-12;

constexpr int recoverable = 1, unrecoverable = -1;

Eigen::Map<Eigen::VectorXd> entries(N_Vector vector) {
    return {N_VGetArrayPointer(vector), static_cast<Eigen::Index>(N_VGetLength(vector))};
}

SUNLinearSolver_Type matrix_embedded(SUNLinearSolver) {
    return SUNLINEARSOLVER_MATRIX_EMBEDDED;
}

} // namespace

SundialsIntegrator::SundialsIntegrator(const std::string& name, const IntegratorOptions& options,
                                       double gamma_may_be_off)
    : Integrator(name, options), gamma_may_be_off_(std::max(gamma_may_be_off, rounding)) {
    SUNContext context = nullptr;
    if (SUNContext_Create(nullptr, &context) != 0)
        throw std::bad_alloc();
    context_.reset(context);
}

void SundialsIntegrator::start(const Vector& memory) {
    if (memory.size() != 0)
        throw InvalidInput(name() + ": cannot go on with a memory: expected none");
    vector_.reset(N_VNew_Serial(state().size(), context()));
    solver_.reset(SUNLinSolNewEmpty(context()));
    if (!vector_ || !solver_)
        throw std::bad_alloc();
    entries(vector()) = state();
    solver()->content = this;
    solver()->ops->gettype = matrix_embedded;
    solver()->ops->solve = call_solve;
    prepared_ = 0;
    heard_.clear();
    thrown_ = nullptr;
    is_finite_ = true;
    create();
}

Arrival SundialsIntegrator::march(double until) {
    require(stop_at(until), "setting the end");
    double reached = time();
    const int answer = evolve(until, reached);
    const auto [steps, rejected, last_step] = engine_counts();
    if (answer >= 0)
        accept(answer == at_root ? reached : until, entries(vector()), last_step);
    counts().steps = static_cast<Index>(steps);
    counts().rejected = static_cast<Index>(rejected);
    require(answer, "marching");
    return answer == at_root ? Arrival::at_event : Arrival::at_time;
}

void SundialsIntegrator::require(int answer, const char* step) {
    if (thrown_)
        std::rethrow_exception(std::exchange(thrown_, nullptr));
    if (answer >= 0)
        return;
    if ((answer == not_converging && !is_finite_) || answer == rate_failed ||
        answer == first_rate_failed || answer == rates_failed)
        fail_of_rate();
    if (answer == too_much_work)
        fail(fmt::format("{} steps do not suffice: allow more by most_steps or larger errors, or, "
                         "if steps are short where the solution is smooth, make what is stiff the "
                         "stiff part",
                         options().most_steps));
    fail(fmt::format("{}: {}", step, heard_.empty() ? fmt::format("error {}", answer) : heard_));
}

int SundialsIntegrator::write(const Vector& values, N_Vector result) {
    entries(result) = values;
    is_finite_ = values.allFinite();
    return is_finite_ ? 0 : recoverable;
}

template <typename Work>
int SundialsIntegrator::guarded(void* self, Work work) {
    auto& integrator = *static_cast<SundialsIntegrator*>(self);
    try {
        return work(integrator);
    } catch (...) {
        integrator.thrown_ = std::current_exception();
        return unrecoverable;
    }
}

int SundialsIntegrator::call_rate(double time, N_Vector state, N_Vector result, void* self) {
    return guarded(self, [&](SundialsIntegrator& integrator) {
        return integrator.write(integrator.rate(time, entries(state)), result);
    });
}

int SundialsIntegrator::call_stiff_rate(double time, N_Vector state, N_Vector result, void* self) {
    return guarded(self, [&](SundialsIntegrator& integrator) {
        return integrator.write(integrator.stiff_rate(time, entries(state)), result);
    });
}

int SundialsIntegrator::call_all_rates(double time, N_Vector state, N_Vector result, void* self) {
    return guarded(self, [&](SundialsIntegrator& integrator) {
        Vector sum = Vector::Zero(entries(state).size());
        if (integrator.problem().rate)
            sum += integrator.rate(time, entries(state));
        if (integrator.is_stiff())
            sum += integrator.stiff_rate(time, entries(state));
        return integrator.write(sum, result);
    });
}

int SundialsIntegrator::call_event(double time, N_Vector state, double* result, void* self) {
    return guarded(self, [&](SundialsIntegrator& integrator) {
        *result = integrator.event(time, entries(state));
        return 0;
    });
}

int SundialsIntegrator::call_weights(N_Vector state, N_Vector weights, void* self) {
    return guarded(self, [&](SundialsIntegrator& integrator) {
        entries(weights) = integrator.allowed(entries(state)).cwiseInverse();
        return 0;
    });
}

void SundialsIntegrator::hear(int code, const char*, const char*, char* text, void* self) {
    if (code < 0)
        static_cast<SundialsIntegrator*>(self)->heard_ = text;
}

int SundialsIntegrator::call_solve(SUNLinearSolver solver, SUNMatrix, N_Vector x, N_Vector b,
                                   double) {
    return guarded(solver->content, [&](SundialsIntegrator& integrator) {
        return integrator.write(integrator.solve_with_current(entries(b)), x);
    });
}

Vector SundialsIntegrator::solve_with_current(const Vector& b) {
    double time = 0, gamma = 0;
    N_Vector state = nullptr;
    current(time, gamma, state);
    const bool is_elsewhere = !is_affine() && time != prepared_time_;
    if (is_elsewhere || !(std::abs(gamma / prepared_ - 1) <= gamma_may_be_off_)) {
        SundialsIntegrator::prepare(time, entries(state), gamma);
        prepared_ = gamma;
        prepared_time_ = time;
    }
    // a solution with another gamma is too long or too short for what decays fast
    const double excess =
        std::abs(gamma / prepared_ - 1) <= rounding ? 1 : 2 / (1 + gamma / prepared_);
    return excess * SundialsIntegrator::solve(b);
}

} // namespace polydec
