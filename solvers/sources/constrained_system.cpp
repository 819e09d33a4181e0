// SPDX-License-Identifier: MIT
#include "solvers/sources/constrained_system.h"

#include "backends/registry.h"
#include "base/checks.h"
#include "base/errors.h"
#include "complex/disjoint_sets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace polydec {

namespace {

void check_sizes(const ConstrainedSystem& system) {
    const auto n = static_cast<std::size_t>(system.A.rows());
    if (system.A.cols() != system.A.rows() || system.fixed.size() != n || system.tied.size() != n ||
        static_cast<std::size_t>(system.weights.size()) != n)
        throw InvalidInput(fmt::format(
            "a constrained system has {} rows, {} columns, {} flags fixed, {} flags tied and {} "
            "weights: expected equal numbers",
            n, system.A.cols(), system.fixed.size(), system.tied.size(), system.weights.size()));
}

/// Weights, of which only ratios matter, scaled by a power of two: the largest is then 1 to 2.
Vector normalized(Vector weights) {
    const double largest = weights.size() > 0 ? weights.maxCoeff() : 0;
    if (largest > 0 && std::isfinite(largest))
        for (double& weight : weights)
            weight = std::ldexp(weight, -std::ilogb(largest));
    return weights;
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

/// Of each unknown, numbered in order; -1 if it is not free.
std::vector<Index> free_components(const SparseMatrix& graph, const std::vector<bool>& fixed,
                                   const std::vector<bool>& tied) {
    const auto n = static_cast<Index>(fixed.size());
    DisjointSets sets(n);
    std::vector<bool> held = tied;
    for (Index i = 0; i < graph.rows(); ++i) {
        Index first = -1;
        bool is_held = false;
        for (SparseMatrix::InnerIterator entry(graph, i); entry; ++entry) {
            const auto j = static_cast<Index>(entry.col());
            if (entry.value() == 0 && i != j)
                continue;
            if (fixed[j])
                is_held = true;
            else if (first < 0)
                first = j;
            else
                sets.join(first, j);
        }
        if (is_held && first >= 0)
            held[first] = true;
    }

    std::vector<bool> held_root(n, false);
    for (Index i = 0; i < n; ++i)
        if (held[i] && !fixed[i])
            held_root[sets.find(i).element] = true;
    std::vector<Index> component(n, -1);
    Index count = 0;
    for (Index i = 0; i < n; ++i)
        if (const Index root = sets.find(i).element; !fixed[i] && !held_root[root])
            component[i] = root == i ? count++ : component[root];
    return component;
}

Index count_of(const std::vector<Index>& component) {
    return component.empty() ? 0 : 1 + *std::max_element(component.begin(), component.end());
}

} // namespace

std::vector<FreeComponents::Run> FreeComponents::runs_of(const std::vector<Index>& component) {
    std::vector<Run> runs;
    for (Index i = 0; i < std::ssize(component); ++i) {
        const Index c = component[i];
        if (c < 0)
            continue;
        if (i == 0 || component[i - 1] != c)
            runs.push_back({c, i, i});
        runs.back().end = i + 1;
    }
    return runs;
}

FreeComponents::FreeComponents(std::vector<Index> component, Index count, Vector weights,
                               std::function<Sums(Sums)> over_all)
    : component_(std::move(component)),
      runs_(runs_of(component_)),
      weights_(std::move(weights)),
      over_all_(std::move(over_all)),
      weights_of_all_(sums(count, [&](Index i) { return weights_[i]; })) {}

FreeComponents::FreeComponents(const SparseMatrix& graph, const std::vector<bool>& fixed,
                               const std::vector<bool>& tied, Vector weights)
    : component_(free_components(graph, fixed, tied)),
      runs_(runs_of(component_)),
      weights_(normalized(std::move(weights))),
      weights_of_all_(sums(count_of(component_), [&](Index i) { return weights_[i]; })) {
    if (!have_means())
        refuse_means();
}

bool FreeComponents::have_means() const {
    return std::all_of(runs_.begin(), runs_.end(),
                       [&](const Run& run) { return weights_of_all_[run.component] > 0; });
}

void refuse_means() {
    throw InvalidInput("the weights of the mean on a component without boundary data have no "
                       "positive sum: use another star, or give boundary values");
}

template <typename Term>
FreeComponents::Sums FreeComponents::sums(Index count, Term term) const {
    Sums own = Sums::Zero(count);
    for (const Run& run : runs_) {
        long double sum = 0;
        for (Index i = run.begin; i < run.end; ++i)
            sum += term(i);
        own[run.component] += sum;
    }
    return over_all_(std::move(own));
}

Compatibility FreeComponents::balance(Vector& b) const {
    const auto magnitude = [&](Index i) { return std::abs(b[i]); };
    const Sums sum = sums(count(), [&](Index i) { return b[i]; }), size = sums(count(), magnitude);
    Compatibility compatibility{count()};
    for (Index c = 0; c < count(); ++c)
        if (const auto share = static_cast<double>(std::abs(sum[c]) / size[c]);
            share > compatibility.worst) {
            compatibility.worst = share;
            compatibility.excess = static_cast<double>(sum[c]);
        }
    for (const auto& [c, begin, end] : runs_)
        for (Index i = begin; i < end; ++i)
            b[i] -= static_cast<double>(sum[c] * weights_[i] / weights_of_all_[c]);
    const Sums rest = sums(count(), magnitude);
    constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
    for (const auto& [c, begin, end] : runs_)
        if (rest[c] <= rounding * size[c])
            b.segment(begin, end - begin).setZero();
    return compatibility;
}

void FreeComponents::remove_means(Vector& u) const {
    const Sums weighted =
        sums(count(), [&](Index i) { return static_cast<long double>(weights_[i]) * u[i]; });
    const Vector means = weighted.cwiseQuotient(weights_of_all_).cast<double>();
    for (const auto& [c, begin, end] : runs_)
        u.segment(begin, end - begin).array() -= means[c];
}

void check_loads(const char* what, const Vector& loads, int degree) {
    for (Index i = 0; i < loads.size(); ++i)
        if (!std::isfinite(loads[i]))
            throw InvalidInput(
                fmt::format(
                    "{} at {}-cell {} is {}: data times volumes leave the range of double "
                    "precision; divide all data by a power of two, and multiply the solution by it",
                    what, degree, i, loads[i]),
                {.degree = degree, .cells = {i}});
}

std::vector<std::string> warning_of(const Compatibility& compatibility) {
    constexpr double rounding = 1e-10;
    if (compatibility.worst <= rounding)
        return {};
    return {fmt::format("the right-hand side does not sum to zero on {} component{} without "
                        "boundary data (relative {:.2g}): its mean was removed",
                        compatibility.free_components,
                        compatibility.free_components == 1 ? "" : "s", compatibility.worst)};
}

ConstrainedSolver::ConstrainedSolver(ConstrainedSystem&& system, const std::string& engine)
    : solver_(make_linear_solver(engine)) {
    SparseMatrix A; // swapped: a move would copy it
    A.swap(system.A);
    system_ = std::move(system);
    system_.A.swap(A);
    check_sizes(system_);
    components_ = {system_.A, system_.fixed, system_.tied, system_.weights};

    // one unknown of each free component is temporarily set to zero
    std::vector<bool> grounded(components_.count(), false);
    for (Index i = 0; i < system_.A.rows(); ++i) {
        if (system_.fixed[i])
            continue;
        const Index component = components_.of(i);
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

Solution ConstrainedSolver::solve(const Vector& b, const Vector& fixed_values) const {
    const auto n = static_cast<Index>(system_.A.rows());
    if (b.size() != n || fixed_values.size() != n)
        throw InvalidInput(
            fmt::format("the right-hand side has {} entries and the fixed values {}: expected {}",
                        b.size(), fixed_values.size(), n));
    if (!fixed_values.allFinite())
        throw InvalidInput(
            "fixed values of a constrained system are not all finite: scale the data");
    Vector u = Vector::Zero(n);
    for (Index i = 0; i < n; ++i)
        if (system_.fixed[i])
            u[i] = fixed_values[i];
    // free components have no fixed neighbors, so there the right side equals b
    Vector right_side = b - system_.A * u;
    for (Index i = 0; i < n; ++i)
        if (system_.fixed[i])
            right_side[i] = 0;
    check_loads("the right-hand side of the system", right_side, system_.degree);
    const Compatibility compatibility = components_.balance(right_side);

    const Vector reduced = right_side(unknowns_);
    const Vector solution = solver_->solve(reduced);
    u(unknowns_) = solution;

    components_.remove_means(u);
    if (!u.allFinite())
        throw SolverFailure("the solution has values that are not finite: data or weights leave "
                            "the range of double precision; scale them");
    return {std::move(u), solver_->report(), compatibility, warning_of(compatibility)};
}

} // namespace polydec
