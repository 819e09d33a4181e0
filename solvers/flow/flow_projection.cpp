// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "dec/forms/cochain.h"
#include "solvers/flow/flow_data.h"
#include "solvers/flow/flow_operators.h"
#include "solvers/sources/constrained_system.h"
#include "solvers/sources/saddle_solver.h"

#include <fmt/format.h>

#include <optional>

namespace polydec {

/// By the multipliers alone where the matrix of the flow is diagonal, else by both together.
struct FlowProjection::Solver {
    SparseMatrix divergence;
    Vector weights; // 1 over the diagonal of star, or empty
    std::optional<ConstrainedSolver> poisson;
    std::optional<SaddleSolver> saddle;

    Solver(const FlowOperators& flow, double theta) : divergence(flow.spaces.divergence) {
        const auto& engine = flow.options.linear_solver;
        if (theta * flow.options.viscosity == 0 && flow.flux_star.is_diagonal()) {
            weights = flow.flux_star.inverse();
            ConstrainedSystem system;
            system.A = divergence * weights.asDiagonal() * SparseMatrix(divergence.transpose());
            system.fixed.assign(divergence.rows(), false);
            system.tied = flow.spaces.tied;
            system.weights = flow.mesh.volumes().primal(flow.n);
            system.definiteness = Definiteness::semidefinite;
            system.domain_dimension = flow.n;
            poisson.emplace(std::move(system), engine);
        } else
            saddle.emplace(matrix(flow, theta), divergence, engine, flow.n);
    }

    static SparseMatrix matrix(const FlowOperators& flow, double theta) {
        SparseMatrix M = flow.flux_star.matrix();
        const double factor = theta * flow.options.viscosity;
        if (factor == 0)
            return M;
        const FormSpace& vorticity = flow.spaces.vorticity;
        const SparseMatrix free = inclusion(flow.spaces.flux.free(), flow.mesh.size(flow.n - 1));
        const SparseMatrix B = SparseMatrix(free.transpose()) * (flow.star * flow.curl).matrix() *
                               inclusion(vorticity.free(), flow.mesh.size(flow.n - 2));
        const Vector inverse = factor * flow.vorticity_star.inverse();
        M += SparseMatrix(B * inverse.asDiagonal() * SparseMatrix(B.transpose()));
        return M;
    }

    Flow solve(const Vector& f, const Vector& g) const {
        if (saddle) {
            const auto [x, c, report] = saddle->solve(f, g);
            return {x, c};
        }
        const Vector none = Vector::Zero(g.size());
        const Vector free = weights.cwiseProduct(f);
        const Vector c = poisson->solve(divergence * free - g, none).values;
        return {free - weights.cwiseProduct(divergence.transpose() * c), c};
    }
};

FlowProjection::FlowProjection(std::shared_ptr<const FlowOperators> operators, double theta)
    : operators_(std::move(operators)), theta_(theta) {
    if (!(theta * operators_->options.viscosity >= 0))
        throw InvalidInput(fmt::format(
            "the part theta of a time step is {}: expected a number of at least 0", theta));
    solver_ = std::make_shared<Solver>(*operators_, theta);
}

FlowProjection::Flow FlowProjection::solve(const Vector& momentum) const {
    const FlowOperators& flow = *operators_;
    Vector right_side = flow.in_unit(momentum, 2, "momenta");
    if (const double factor = theta_ * flow.options.viscosity; factor > 0)
        right_side -= factor * flow.curl_of(flow.vorticity(flow.boundary_flux, 1));
    return solve(right_side, flow.boundary_flux);
}

FlowProjection::Flow FlowProjection::solve_at_rest(const Vector& momentum) const {
    if (theta_ != 0)
        throw InvalidInput(
            "a projection with friction cannot solve for a flow at rest: use theta = 0");
    return solve(operators_->in_unit(momentum, 2, "momenta"), Vector::Zero(momentum.size()));
}

FlowProjection::Flow FlowProjection::solve(const Vector& momentum, const Vector& boundary) const {
    const FlowOperators& flow = *operators_;
    const Vector f = flow.spaces.flux.restrict(Vector(momentum - flow.star * boundary));
    const Vector g = -(Operator::derivative(flow.mesh.complex(), flow.n - 1) * boundary);
    auto [x, c] = solver_->solve(f, g);
    Vector flux = boundary;
    flux(flow.spaces.flux.free()) = x;
    return {flow.in_input(flux, flow.n, "fluxes"), std::move(c)};
}

} // namespace polydec
