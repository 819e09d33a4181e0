// SPDX-License-Identifier: MIT
#include "solvers/surfaces/heat_step.h"

#include "backends/registry.h"
#include "base/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace polydec {

namespace {

/// Eliminates the unknowns of value 1 from a symmetric system, keeping its diagonal; returns their
/// contribution to the right-hand side.
Vector hold(SparseMatrix& A, const std::vector<Index>& held) {
    Vector marks = Vector::Zero(A.rows());
    for (const Index v : held)
        marks[v] = 1;
    const Vector diagonal = A.diagonal();
    const Vector right =
        marks.cwiseProduct(diagonal) - (Vector::Ones(A.rows()) - marks).cwiseProduct(A * marks);
    A.prune([&](Index i, Index j, double) { return i == j || marks[i] + marks[j] == 0; });
    return right;
}

} // namespace

HeatStep::HeatStep(const SurfaceMetric& metric, const Vector& times, const std::string& engine,
                   std::span<const Index> held)
    : times_(times),
      engine_(engine),
      held_(held.begin(), held.end()),
      solver_(make_linear_solver(engine)) {
    SparseMatrix A(metric.surface.vertices(), metric.surface.vertices());
    A.setIdentity();
    A = metric.vertex_areas.asDiagonal() * A;
    A += surface_laplacian(metric, times);
    from_held_ = hold(A, held_);
    solver_->factorize(A, {.symmetry = Symmetry::symmetric,
                           .definiteness = Definiteness::positive,
                           .domain_dimension = 2,
                           .many_solves = true});
}

DenseMatrix HeatStep::operator()(const DenseMatrix& b) const {
    DenseMatrix u = solver_->solve(b.colwise() + from_held_);
    if (!u.allFinite())
        throw SolverFailure(
            fmt::format("{} returned heat that is not finite: the triangles are too badly shaped",
                        solver_->report().engine));
    return u;
}

HeatFlow HeatStep::from(const SurfaceMetric& metric, const DenseMatrix& b) const {
    HeatFlow flow{(*this)(b), times_};
    Vector times = longer(metric, flow.u.col(0));
    while (times != flow.times) {
        const HeatStep step(metric, times, engine_, held_);
        flow = {step(b), times};
        times = step.longer(metric, flow.u.col(0));
    }
    return flow;
}

Vector HeatStep::longer(const SurfaceMetric& metric, const Vector& u) const {
    // A factorization keeps the digits of heat that decays by a constant factor per edge, until
    // underflow. Iteration keeps only digits of values not far below the largest.
    const std::string& name = solver_->report().engine;
    const EngineTraits traits =
        has_linear_solver(name) ? make_linear_solver(name)->traits() : solver_->traits();
    const bool iterative = traits.method == Method::iterative;
    const double faintest = iterative ? 1e-8 : 1e-250;
    Vector largest = Vector::Zero(times_.size()), result = times_;
    for (Eigen::Index v = 0; v < u.size(); ++v)
        largest[metric.component[v]] = std::max(largest[metric.component[v]], std::abs(u[v]));
    for (Eigen::Index v = 0; v < u.size(); ++v)
        if (const Index c = metric.component[v]; std::abs(u[v]) <= faintest * largest[c])
            result[c] = 4 * times_[c];
    return result;
}

} // namespace polydec
