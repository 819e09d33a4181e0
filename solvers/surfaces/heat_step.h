// SPDX-License-Identifier: MIT
#pragma once

#include "backends/linear_solver.h"
#include "solvers/surfaces/surface_metric.h"

namespace polydec {

/// One step of backward Euler for the heat equation, for functions: (M + t L) u = b, with times t
/// for each component.
class HeatStep {
public:
    HeatStep(const Triangles& surface, const SurfaceMetric& metric, const Vector& times,
             const std::string& engine);

    /// A column per right-hand side.
    DenseMatrix operator()(const DenseMatrix& b);

    /// The times, longer on the components where u, a first column that the step gave for heat of
    /// size 1 at the sources, is too faint at some vertex for its digits to be trusted.
    Vector longer(const SurfaceMetric& metric, const Vector& u) const;

    const Vector& times() const { return times_; }

private:
    Vector times_;
    std::unique_ptr<LinearSolver> solver_;
};

} // namespace polydec
