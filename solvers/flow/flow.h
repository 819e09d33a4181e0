// SPDX-License-Identifier: MIT
#pragma once

#include "solvers/flow/incompressible_flow.h"
#include "solvers/time/fixed_steps.h"

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

/// An incompressible flow that runs, with one factorization for all steps. A midpoint is found by
/// solving with friction and last pass's inertia until nothing changes any more, which it does for
/// steps below about the exchange time.
class Flow final : public FixedSteps {
public:
    /// From a flow as IncompressibleFlow::project makes. Throws InvalidInput unless the time step
    /// is positive, and for another number of fluxes than facets; what linear engines throw.
    Flow(const IncompressibleFlow& equations, const Vector& start, const FlowSteps& steps);

    const IncompressibleFlow& equations() const { return equations_; }

    /// The flux now, and as the only one of the forms.
    const Vector& flux() const { return now()[0]; }
    std::vector<Cochain> forms() const override;

    std::optional<Fingerprint> fingerprint() const override;

private:
    /// Throws SolverFailure if a midpoint is not found: steps must be shorter.
    void step(std::vector<Vector>& state) const override;
    Vector midpoint(const Vector& w) const;
    Vector imex(const Vector& w) const;

    IncompressibleFlow equations_;
    FlowSteps steps_;
    Vector start_;
    FlowProjection implicit_, projection_;
};

} // namespace polydec
