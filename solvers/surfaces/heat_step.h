// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear_solver.h"
#include "solvers/surfaces/surface_metric.h"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace polydec {

/// Heat, one column per right-hand side, and its diffusion time on each component.
struct HeatFlow {
    DenseMatrix u;
    Vector times;
};

/// One step of backward Euler for the heat equation on functions: solves (M + t L) u = b with one
/// time t per component, or with u = 1 at the held vertices.
class HeatStep {
public:
    HeatStep(const SurfaceMetric& metric, const Vector& times, const std::string& engine,
             std::span<const Index> held = {});

    /// One column per right-hand side.
    DenseMatrix operator()(const DenseMatrix& b) const;

    const Vector& times() const { return times_; }

    /// The step from b, one column per right-hand side; the first gives heat of size 1 at sources.
    /// Times are longer on components where heat would be too faint at some vertex for trusted
    /// digits.
    HeatFlow from(const SurfaceMetric& metric, const DenseMatrix& b) const;

private:
    Vector longer(const SurfaceMetric& metric, const Vector& u) const;

    Vector times_;
    std::string engine_; // as requested
    std::vector<Index> held_;
    Vector from_held_; // right-hand side of u = 1 at the held vertices
    std::unique_ptr<LinearSolver> solver_;
};

} // namespace polydec
