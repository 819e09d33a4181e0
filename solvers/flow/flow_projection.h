// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <memory>

namespace polydec {

struct FlowOperators;

/// Takes what gradients do out of a flow, and friction with it. Made by IncompressibleFlow; a
/// handle, used by one thread at a time. All is in the units of the input.
class FlowProjection {
public:
    /// Throws what linear engines throw, and InvalidInput for theta * viscosity < 0.
    FlowProjection(std::shared_ptr<const FlowOperators> operators, double theta);

    double theta() const { return theta_; }

    struct Flow {
        Vector flux;       ///< w: size(n-1)
        Vector multiplier; ///< c: size(n), which may be rounding alone; in the unit of the mesh
    };

    /// The flow w that the boundary data ask for, without divergence, with star w - theta
    /// friction(w) + d^T c = momentum at all facets but those whose flux is given.
    Flow solve(const Vector& momentum) const;

    /// The same for boundary data that are 0, and without friction: for rates of change. Throws
    /// InvalidInput unless theta is 0.
    Flow solve_at_rest(const Vector& momentum) const;

private:
    struct Solver;

    /// Of data in the unit of the mesh.
    Flow solve(const Vector& momentum, const Vector& boundary) const;

    std::shared_ptr<const FlowOperators> operators_;
    double theta_;
    std::shared_ptr<const Solver> solver_;
};

} // namespace polydec
