// SPDX-License-Identifier: MIT
#pragma once

#include "solvers/flow/incompressible_flow.h"

namespace polydec {

/// How a step of a flow is taken.
enum class FlowScheme {
    implicit_midpoint, ///< second order; keeps the energy without viscosity, to the tolerance
    imex,              ///< third order: inertia explicit, friction implicit (Ascher, Ruuth, Spiteri
                       ///< 1997, scheme (3,4,3)); steps up to about the exchange time
};

struct FlowSteps {
    double time_step = 0;
    FlowScheme scheme = FlowScheme::implicit_midpoint;
    double tolerance = 1e-13; ///< of the midpoint: change of the flow in the last pass, relative
    int most_passes = 100;
};

/// Marches an incompressible flow, with one factorization for all steps. A midpoint is found by
/// solving with friction and last pass's inertia until nothing changes any more, which it does for
/// steps below about the exchange time.
class FlowSolver {
public:
    /// Throws InvalidInput unless the time step is positive; what linear engines throw.
    FlowSolver(const IncompressibleFlow& flow, const FlowSteps& steps);

    /// The flow one step later, of a flow as IncompressibleFlow::project makes. Throws
    /// SolverFailure if a midpoint is not found: steps must be shorter.
    Vector step(const Vector& w) const;

    const IncompressibleFlow& flow() const { return flow_; }

private:
    Vector midpoint(const Vector& w) const;
    Vector imex(const Vector& w) const;

    IncompressibleFlow flow_;
    FlowSteps steps_;
    FlowProjection implicit_, projection_;
};

} // namespace polydec
