// SPDX-License-Identifier: MIT
#pragma once

#include "solvers/flow/incompressible_flow.h"
#include "solvers/time/diffusion.h"

namespace polydec {

/// The scheme of a time step.
enum class FlowScheme {
    implicit_midpoint, ///< second order; keeps the energy without viscosity, to the tolerance
    imex,              ///< third order: explicit inertia, implicit friction (Ascher, Ruuth, Spiteri
                       ///< 1997, scheme (3,4,3)); steps up to about the exchange time
};

struct FlowSteps {
    double time_step = 0;
    FlowScheme scheme = FlowScheme::implicit_midpoint;
    double tolerance = 1e-13; ///< of the midpoint: relative change of the flow in the last pass
    int most_passes = 100;    ///< at least 1
};

/// An incompressible flow in time, with one factorization for all steps. The midpoint is found by
/// fixed-point iteration on the inertia, which converges for steps below about the exchange time.
class Flow final : public FixedSteps {
public:
    /// `start` is a flow, as from IncompressibleFlow::project. Throws InvalidInput unless the time
    /// step is positive, there is one finite flux per facet, the tolerance is at least 0 and a pass
    /// is allowed; and like LinearSolver.
    Flow(const IncompressibleFlow& equations, const Vector& start, const FlowSteps& steps);

    /// The current flux, also the only form in forms().
    const Vector& flux() const& { return now()[0]; }
    Vector flux() && { return flux(); }
    std::vector<Cochain> forms() const override;

    /// Friction that is too fast for steps by the midpoint: at rates above 2 / time_step, small
    /// eddies change sign in each step instead of dying away.
    std::vector<std::string> warnings() const override;

    std::optional<Fingerprint> fingerprint() const override;

private:
    /// Throws SolverFailure if the midpoint iteration fails: steps must be shorter.
    void step(std::vector<Vector>& state) const override;
    StepPlan limit() const override;
    Vector midpoint(const Vector& w) const;
    Vector imex(const Vector& w) const;

    IncompressibleFlow equations_;
    FlowSteps steps_;
    Vector start_;
    FlowProjection implicit_, projection_;
};

} // namespace polydec
