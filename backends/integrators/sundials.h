// SPDX-License-Identifier: MIT
#pragma once

#include "backends/integrator.h"

#include <exception>
#include <memory>
#include <string>
#include <sundials/sundials_context.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_nvector.h>
#include <type_traits>

namespace polydec {

template <auto free_it>
struct FreeBy {
    template <typename Handle>
    void operator()(Handle* handle) const {
        free_it(handle);
    }
};
inline void free_context(SUNContext context) {
    SUNContext_Free(&context);
}
using SundialsContext = std::unique_ptr<std::remove_pointer_t<SUNContext>, FreeBy<free_context>>;
using SundialsVector = std::unique_ptr<std::remove_pointer_t<N_Vector>, FreeBy<N_VDestroy>>;
using SundialsSolver =
    std::unique_ptr<std::remove_pointer_t<SUNLinearSolver>, FreeBy<SUNLinSolFreeEmpty>>;

/// What the integrators of SUNDIALS have in common: our functions as theirs, and their answers as
/// ours. Nothing of C++ is thrown through their code.
class SundialsIntegrator : public Integrator {
protected:
    /// How far the gamma of a factorization may be off, where Newton's method does the rest.
    SundialsIntegrator(const std::string& name, const IntegratorOptions& options,
                       double gamma_may_be_off);

    void start(const Vector& memory) final;
    Arrival march(double until) final;

    /// Numbers that the return codes of ARKODE and CVODE share.
    enum Answer {
        success = 0,
        stopped = 1,
        at_root = 2,
        too_much_work = -1,
        not_converging = -4,
        rate_failed = -8,
        first_rate_failed = -9,
        rates_failed = -10
    };

    /// Of the engine.
    struct Counts {
        long steps = 0, rejected = 0;
        double last_step = 0;
    };
    virtual void create() = 0;
    virtual int stop_at(double time) = 0; ///< to go no further
    virtual int evolve(double until, double& reached) = 0;
    virtual Counts engine_counts() const = 0;
    virtual void current(double& time, double& gamma, N_Vector& state) const = 0;

    bool is_affine() const { return problem().stiff->linearity == Linearity::affine; }
    SUNContext context() const { return context_.get(); }
    N_Vector vector() const { return vector_.get(); }
    SUNLinearSolver solver() const { return solver_.get(); }

    /// Throws what an engine's answer below 0 says.
    void require(int answer, const char* step);

    static int call_rate(double time, N_Vector state, N_Vector result, void* self);
    static int call_stiff_rate(double time, N_Vector state, N_Vector result, void* self);
    static int call_all_rates(double time, N_Vector state, N_Vector result, void* self);
    static int call_event(double time, N_Vector state, double* result, void* self);
    static int call_weights(N_Vector state, N_Vector weights, void* self);
    static void hear(int code, const char* module, const char* function, char* text, void* self);

private:
    static int call_solve(SUNLinearSolver solver, SUNMatrix, N_Vector x, N_Vector b, double);
    Vector solve_with_current(const Vector& b);
    int write(const Vector& values, N_Vector result);

    template <typename Work>
    static int guarded(void* self, Work work);

    SundialsContext context_;
    SundialsVector vector_; ///< of the state; the engine's own copy is its own
    SundialsSolver solver_;
    double gamma_may_be_off_;
    double prepared_ = 0; ///< the gamma that can be solved with
    double prepared_time_ = 0;
    bool is_finite_ = true; ///< what the engine was given last
    std::string heard_;     ///< what the engine said last
    std::exception_ptr thrown_;
};

} // namespace polydec
