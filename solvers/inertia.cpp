// SPDX-License-Identifier: MIT
#include "solvers/inertia.h"

#include "backends/registry.h"
#include "base/errors.h"

#include <algorithm>
#include <cmath>

namespace polydec {

InertiaCounter::InertiaCounter(std::shared_ptr<const SparseMatrix> B, const std::string& engine,
                               int domain_dimension)
    : B_(std::move(B)), solver_(make_linear_solver(engine)), norm_(row_sum_norm(*B_)) {
    facts_.symmetry = Symmetry::symmetric;
    facts_.definiteness = Definiteness::indefinite;
    facts_.inertia = Inertia::wanted;
    facts_.domain_dimension = domain_dimension;
}

InertiaCounter::~InertiaCounter() = default;

std::optional<Index> InertiaCounter::below(double shift, double gap) {
    try {
        solver_->factorize(std::make_shared<const SparseMatrix>(shifted(*B_, shift)), facts_);
        // growth of the pivots shows in a solve with an uneven right-hand side
        Vector probe(B_->rows());
        for (Index i = 0; i < probe.size(); ++i)
            probe[i] = std::sin(1.0 + i);
        solver_->solve(probe);
    } catch (const SolverFailure&) {
        return std::nullopt;
    }
    constexpr double far_below = 1e-2;
    if (!(solver_->report().backward_error * (norm_ + std::abs(shift)) <= far_below * gap))
        return std::nullopt;
    return solver_->negative_pivots();
}

SparseMatrix shifted(const SparseMatrix& B, double shift) {
    SparseMatrix I(B.rows(), B.cols());
    I.setIdentity();
    return B - shift * I;
}

double row_sum_norm(const SparseMatrix& B) {
    double norm = 0;
    for (Index i = 0; i < B.rows(); ++i) {
        double sum = 0;
        for (SparseMatrix::InnerIterator entry(B, i); entry; ++entry)
            sum += std::abs(entry.value());
        norm = std::max(norm, sum);
    }
    return norm;
}

} // namespace polydec
