// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear_solver.h"
#include "solvers/surfaces/surface_metric.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace polydec {

/// Heat, a column per right-hand side, and for which times it has flowed on the components.
struct HeatFlow {
    DenseMatrix u;
    Vector times;
};

/// One step of backward Euler for the heat equation, for functions: (M + t L) u = b, with times t
/// for each component; or u = 1 at the vertices that are held.
class HeatStep {
public:
    HeatStep(const Triangles& surface, const SurfaceMetric& metric, const Vector& times,
             const std::string& engine, std::span<const Index> held = {});

    /// A column per right-hand side.
    DenseMatrix operator()(const DenseMatrix& b) const;

    const Vector& times() const { return times_; }

    /// The step from b, a column per right-hand side, of which the first gives heat of size 1 at
    /// sources: for longer times on the components where that would be too faint at some vertex for
    /// its digits to be trusted.
    HeatFlow from(const Triangles& surface, const SurfaceMetric& metric,
                  const DenseMatrix& b) const;

private:
    Vector longer(const SurfaceMetric& metric, const Vector& u) const;

    Vector times_;
    std::string engine_; // as it was asked for
    std::vector<Index> held_;
    Vector from_held_; // right side of u = 1 at the held ones
    std::unique_ptr<LinearSolver> solver_;
};

} // namespace polydec
