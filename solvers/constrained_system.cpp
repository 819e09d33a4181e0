// SPDX-License-Identifier: MIT
#include "solvers/constrained_system.h"

#include "backends/registry.h"
#include "base/checks.h"
#include "base/errors.h"
#include "complex/disjoint_sets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace polydec {

namespace {

void check_sizes(const ConstrainedSystem& system) {
    const auto n = static_cast<std::size_t>(system.A.rows());
    if (system.A.cols() != system.A.rows() || system.fixed.size() != n || system.tied.size() != n ||
        static_cast<std::size_t>(system.weights.size()) != n)
        throw InvalidInput(fmt::format("constrained system of {} rows, {} columns, {} flags fixed, "
                                       "{} flags tied, {} weights: expected equal sizes",
                                       n, system.A.cols(), system.fixed.size(), system.tied.size(),
                                       system.weights.size()));
}

/// Only ratios of weights matter: a power of two makes the largest 1 to 2.
void normalize(Vector& weights) {
    const double largest = weights.size() > 0 ? weights.maxCoeff() : 0;
    if (largest > 0 && std::isfinite(largest))
        for (double& weight : weights)
            weight = std::ldexp(weight, -std::ilogb(largest));
}

/// The rows and columns of A in the list.
SparseMatrix part(const SparseMatrix& A, const std::vector<Index>& list) {
    std::vector<Index> place(A.rows(), -1);
    for (std::size_t i = 0; i < list.size(); ++i)
        place[list[i]] = static_cast<Index>(i);
    SparseMatrix result(static_cast<Index>(list.size()), static_cast<Index>(list.size()));
    result.reserve(A.nonZeros());
    for (std::size_t i = 0; i < list.size(); ++i) {
        result.startVec(static_cast<Index>(i));
        for (SparseMatrix::InnerIterator entry(A, list[i]); entry; ++entry)
            if (place[entry.col()] >= 0)
                result.insertBack(static_cast<Index>(i), place[entry.col()]) = entry.value();
    }
    result.finalize();
    return result;
}

} // namespace

ConstrainedSolver::ConstrainedSolver(ConstrainedSystem&& system, const std::string& engine)
    : solver_(make_linear_solver(engine)) {
    SparseMatrix A; // what moves would be copied
    A.swap(system.A);
    system_ = std::move(system);
    system_.A.swap(A);
    check_sizes(system_);
    normalize(system_.weights);
    find_components();

    // one unknown of each free component is set to zero for the time being
    std::vector<bool> grounded(free_components_, false);
    for (Index i = 0; i < system_.A.rows(); ++i) {
        if (system_.fixed[i])
            continue;
        const Index component = component_[i];
        if (component < 0 || grounded[component])
            unknowns_.push_back(i);
        else
            grounded[component] = true;
    }
    MatrixFacts facts;
    facts.symmetry = Symmetry::symmetric;
    facts.definiteness = system_.definiteness == Definiteness::indefinite ? Definiteness::indefinite
                                                                          : Definiteness::positive;
    facts.domain_dimension = system_.domain_dimension;
    solver_->factorize(part(system_.A, unknowns_), facts);
}

/// Components of the graph of A among the unknowns that are not fixed; those that touch a fixed or
/// tied unknown are regular and get no number.
void ConstrainedSolver::find_components() {
    const auto n = static_cast<Index>(system_.A.rows());
    DisjointSets sets(n);
    std::vector<bool> held = system_.tied;
    for (Index i = 0; i < n; ++i)
        for (SparseMatrix::InnerIterator entry(system_.A, i); entry; ++entry) {
            const auto j = static_cast<Index>(entry.col());
            if (entry.value() == 0 || system_.fixed[i])
                continue;
            if (system_.fixed[j])
                held[i] = true;
            else
                sets.join(i, j);
        }

    std::vector<bool> held_root(n, false);
    for (Index i = 0; i < n; ++i)
        if (held[i] && !system_.fixed[i])
            held_root[sets.find(i).element] = true;
    std::vector<Index> number(n, -1);
    component_.assign(n, -1);
    for (Index i = 0; i < n; ++i) {
        const Index root = sets.find(i).element;
        if (system_.fixed[i] || held_root[root])
            continue;
        if (number[root] < 0)
            number[root] = free_components_++;
        component_[i] = number[root];
    }
}

Solution<DenseMatrix> ConstrainedSolver::solve_all(const DenseMatrix& b,
                                                   const DenseMatrix& fixed_values) const {
    check_as_many("columns of fixed values", fixed_values.cols(), b.cols());
    Solution<DenseMatrix> all{DenseMatrix(system_.A.rows(), b.cols()), {}, {}};
    for (Eigen::Index j = 0; j < b.cols(); ++j) {
        auto [u, report, compatibility] = solve(Vector(b.col(j)), Vector(fixed_values.col(j)));
        all.values.col(j) = u;
        report.iterations = std::max(report.iterations, all.report.iterations);
        report.residual = std::max(report.residual, all.report.residual);
        report.backward_error = std::max(report.backward_error, all.report.backward_error);
        compatibility.worst = std::max(compatibility.worst, all.compatibility.worst);
        all.report = std::move(report);
        all.compatibility = compatibility;
    }
    return all;
}

Solution<Vector> ConstrainedSolver::solve(const Vector& b, const Vector& fixed_values) const {
    const auto n = static_cast<Index>(system_.A.rows());
    if (b.size() != n || fixed_values.size() != n)
        throw InvalidInput(fmt::format("right-hand side of {} and fixed values of {} entries: "
                                       "expected {}",
                                       b.size(), fixed_values.size(), n));
    if (!b.allFinite() || !fixed_values.allFinite())
        throw InvalidInput("right-hand side or fixed values of a constrained system are not "
                           "finite: scale the data");
    Vector sum = Vector::Zero(free_components_), size = sum, weight = sum, mean = sum;
    for (Index i = 0; i < n; ++i)
        if (const Index c = component_[i]; c >= 0) {
            sum[c] += b[i];
            size[c] += std::abs(b[i]);
            weight[c] += system_.weights[i];
        }
    Compatibility compatibility{free_components_, 0};
    for (Index c = 0; c < free_components_; ++c)
        if (size[c] > 0)
            compatibility.worst = std::max(compatibility.worst, std::abs(sum[c]) / size[c]);

    Vector u = Vector::Zero(n);
    for (Index i = 0; i < n; ++i)
        if (system_.fixed[i])
            u[i] = fixed_values[i];
    Vector right_side = b - system_.A * u;
    for (Index i = 0; i < n; ++i)
        if (const Index c = component_[i]; c >= 0)
            right_side[i] -= sum[c] * system_.weights[i] / weight[c];

    const Vector reduced = right_side(unknowns_);
    const Vector solution = solver_->solve(reduced);
    u(unknowns_) = solution;

    for (Index i = 0; i < n; ++i)
        if (const Index c = component_[i]; c >= 0)
            mean[c] += system_.weights[i] * u[i] / weight[c];
    for (Index i = 0; i < n; ++i)
        if (const Index c = component_[i]; c >= 0)
            u[i] -= mean[c];
    if (!u.allFinite())
        throw SolverFailure("the solution has values that are not finite: data or weights leave "
                            "the range of numbers; scale them");
    return {std::move(u), solver_->report(), compatibility};
}

} // namespace polydec
