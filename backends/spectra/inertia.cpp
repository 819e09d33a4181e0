// SPDX-License-Identifier: MIT
#include "backends/spectra/inertia.h"

#include "backends/registry.h"
#include "base/row_sum_norm.h"
#include "system/memory.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace polydec {

namespace {

/// Enough to know the smallest eigenvalue to a small factor.
constexpr int inverse_iterations = 4;

/// Halvings of an interval on the axis; each costs a factorization.
constexpr int most_bisections = 40;

} // namespace

TrustedInertia::TrustedInertia(const std::string& engine, int domain_dimension)
    : engine_(engine), solver_(make_linear_solver(engine)) {
    facts_.symmetry = Symmetry::symmetric;
    facts_.definiteness = Definiteness::indefinite;
    facts_.inertia = Inertia::wanted;
    facts_.domain_dimension = domain_dimension;
}

std::optional<Index> TrustedInertia::negative(SparseMatrix B, const Vector& sizes, double share) {
    // without rounding, D^2 sizes from 1/4 to 1
    scale_ = sizes.unaryExpr([](double size) {
        return size > 0 ? std::ldexp(1.0, -((std::ilogb(size) + 2) >> 1)) : 1.0;
    });
    const auto S = std::make_shared<SparseMatrix>();
    S->swap(B);
    for (Index i = 0; i < S->rows(); ++i)
        for (SparseMatrix::InnerIterator entry(*S, i); entry; ++entry)
            entry.valueRef() *= scale_[i] * scale_[entry.col()];
    const auto count = trusted(S, share);
    if (S->rows() > most_beside_another)
        solver_ = make_linear_solver(engine_);
    return count;
}

DenseMatrix TrustedInertia::solve(const DenseMatrix& X) const {
    return scale_.asDiagonal() * solver_->solve(DenseMatrix(scale_.asDiagonal() * X));
}

std::optional<Index> TrustedInertia::trusted(const std::shared_ptr<const SparseMatrix>& S,
                                             double share) {
    Vector probe = Vector::NullaryExpr(S->rows(), [](Index i) { return std::sin(1.0 + i); });
    double lost = 0;
    try {
        solver_->factorize(S, facts_);
        // growth of the pivots shows in solves
        for (int step = 0; step < inverse_iterations; ++step) {
            probe = solver_->solve(probe.normalized());
            lost = std::max(lost, solver_->report().backward_error);
        }
    } catch (const OutOfMemory&) {
        throw; // it would need as much at another shift
    } catch (const SolverFailure&) {
        return std::nullopt;
    }
    // inverse iteration comes to the smallest eigenvalue from above
    constexpr double far_below = 1e-2, below = 0.25;
    const double smallest = 1 / probe.norm();
    if (!(share < below * smallest && lost * row_sum_norm(*S) <= far_below * smallest))
        return std::nullopt;
    return solver_->negative_pivots();
}

std::optional<Index> InertiaCounter::below(double shift, double gap) {
    if (!(doubt_.relative * std::abs(shift) < gap))
        return std::nullopt;
    const auto negative = inertia_.negative(
        matrices_.at(shift), doubt_.sizes + std::abs(shift) * matrices_.M.diagonal(), doubt_.share);
    if (!negative || *negative < matrices_.hidden)
        return std::nullopt;
    return *negative - matrices_.hidden;
}

std::optional<InertiaCounter::Counted> InertiaCounter::between(double low, double high,
                                                               Index known) {
    for (const double place : {0.5, 0.38, 0.63, 0.27, 0.71}) {
        const double shift = low + place * (high - low);
        const auto count = below(shift, std::min(place, 1 - place) * (high - low));
        if (count && *count >= known)
            return Counted{shift, *count};
    }
    return std::nullopt;
}

double InertiaCounter::shift_close_to(Index done, Index wanted, double low, double high,
                                      double length) {
    bool is_near = false; // whether `high` has no more than those wanted below it
    for (int step = 0; step < most_bisections; ++step) {
        // a multiplet of more copies than wanted has no shift that is near enough; nearer than this
        // the factorization would lose digits
        if (high - low < 1e-3 * std::max(std::abs(low), length))
            break;
        const double middle =
            length * std::sinh((std::asinh(low / length) + std::asinh(high / length)) / 2);
        const auto count = below(middle, 1e-3 * (high - low));
        if (!count)
            break;
        if (*count <= done) {
            low = middle;
            continue;
        }
        high = middle;
        if (std::exchange(is_near, *count <= done + wanted))
            break;
    }
    return low;
}

double small_length(const SparseMatrix& B) {
    Vector diagonal = B.diagonal().cwiseAbs();
    std::sort(diagonal.begin(), diagonal.end());
    const double norm = row_sum_norm(B);
    double typical = diagonal[diagonal.size() / 64];
    if (typical == 0)
        typical = diagonal[diagonal.size() / 2];
    if (typical == 0)
        typical = norm > 0 ? norm : 1;
    return std::max(1e-3 * typical / std::sqrt(static_cast<double>(B.rows())), 1e-12 * norm);
}

} // namespace polydec
