// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <memory>

namespace polydec {

struct FlowOperators;

/// Projects momenta to flows without divergence, with implicit friction. Made by
/// IncompressibleFlow. A handle; use it from one thread at a time. In the units of the input.
class FlowProjection {
public:
    /// `theta` is a time that multiplies the friction. Throws InvalidInput for theta * viscosity <
    /// 0, and like LinearSolver.
    FlowProjection(std::shared_ptr<const FlowOperators> operators, double theta);

    double theta() const { return theta_; }

    struct Flow {
        Vector flux;       ///< w: size(n-1)
        Vector multiplier; ///< c: size(n), in the unit of the mesh; may be rounding only
    };

    /// The flow w without divergence that has the boundary data and satisfies star w - theta
    /// friction(w) + d^T c = momentum at all facets without a known flux.
    Flow solve(const Vector& momentum) const;

    /// The same with boundary data 0 and without friction, for rates of change. Throws InvalidInput
    /// unless theta is 0.
    Flow solve_at_rest(const Vector& momentum) const;

private:
    struct Solver;

    /// Takes data in the unit of the mesh.
    Flow solve(const Vector& momentum, const Vector& boundary) const;

    std::shared_ptr<const FlowOperators> operators_;
    double theta_;
    std::shared_ptr<const Solver> solver_;
};

} // namespace polydec
