// SPDX-License-Identifier: MIT
#include "shape/lower_bounds.h"

#include "backends/registry.h"
#include "base/decompositions.h"
#include "base/errors.h"
#include "shape/lehmann_bounds.h"
#include "system/memory.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polydec {

namespace {

/// The forms X^T Q(s) X and minus their derivative by s.
struct Projected {
    double s = 0;
    DenseMatrix Q, slope, image; ///< image: Q(s) X
};

Projected project(const FormFamily& family, const DenseMatrix& X, double s) {
    constexpr double step = 1e-4;
    Projected result{s, {}, {}, *family.at(s).matrix * X};
    result.Q = X.transpose() * result.image;
    const DenseMatrix before = X.transpose() * (*family.at(s * (1 - step)).matrix * X);
    result.slope = (before - result.Q) / (s * step);
    return result;
}

/// One step of Newton for all values, in the space of X; X becomes their vectors, and `residuals`
/// are Q(s) times these. Values that differ by a share below `nearby` have one s. False if X says
/// nothing.
bool rotate(const FormFamily& family, DenseMatrix& X, Vector& values, DenseMatrix& residuals,
            double nearby) {
    DenseMatrix rotated(X.rows(), X.cols());
    residuals.resize(X.rows(), X.cols());
    Projected at;
    Eigen::GeneralizedSelfAdjointEigenSolver<DenseMatrix> ritz;
    const double most = 0.98 * family.limit();
    for (Eigen::Index j = 0; j < X.cols(); ++j) {
        const double s = std::clamp(values[j], 0.0, most);
        if (s > 0 && !(std::abs(s - at.s) <= nearby * s)) {
            at = project(family, X, s);
            ritz.compute((at.Q + at.Q.transpose()) / 2, (at.slope + at.slope.transpose()) / 2);
            if (ritz.info() != Eigen::Success || !ritz.eigenvectors().allFinite())
                return false;
        }
        if (!(at.s > 0)) { // zeros
            rotated.col(j) = X.col(j);
            residuals.col(j).setZero();
            continue;
        }
        const auto y = ritz.eigenvectors().col(j);
        values[j] = std::clamp(at.s + ritz.eigenvalues()[j], 0.0, most);
        rotated.col(j) = X * y;
        residuals.col(j) = at.image * y;
    }
    X = rotated;
    return true;
}

/// Numbers s at which eigenvalues of Q(s) vanish, one per column of X, with their vectors; the j-th
/// one belongs to the j-th smallest eigenvalue. They are nearly the best lower bounds that counts
/// can prove. X has the unknowns of approximate eigenfunctions, `values` their approximate
/// eigenvalues. Uses the Rayleigh-Ritz method for s-dependent matrices and a step of residual
/// inverse iteration (Neumaier 1985). The results are guesses and prove nothing.
LowerGuesses lower_guesses(const FormFamily& family, DenseMatrix X, const Vector& given,
                           const std::string& engine) {
    Vector values = given;
    DenseMatrix residuals;
    if (!rotate(family, X, values, residuals, 0.1))
        return {given, X};
    // errors are of functions far above; in between, so that none of these is blown up
    const double shift = std::min(0.7 * values.maxCoeff(), 0.9 * family.limit());
    MatrixFacts facts;
    facts.symmetry = Symmetry::symmetric;
    facts.inertia =
        Inertia::wanted; // residuals of nearly singular matrices are looked at elsewhere
    facts.domain_dimension = family.domain_dimension();
    const auto solver = make_linear_solver(engine);
    try {
        solver->factorize(family.at(shift).matrix, facts);
        DenseMatrix better = X - solver->solve(residuals);
        if (Vector near = values;
            better.allFinite() && rotate(family, better, near, residuals, 1e-2))
            return {near, better};
    } catch (const OutOfMemory&) {
        throw;
    } catch (const SolverFailure&) { // then these have to do
    }
    return {values, X};
}

} // namespace

LowerBounds::LowerBounds(FamilyCounter& counter, const ShapeSpectrumOptions& options, Vector upper,
                         Index zeros, DenseMatrix vectors)
    : counter_(counter),
      options_(options),
      upper_(std::move(upper)),
      zeros_(zeros),
      vectors_(std::move(vectors)),
      lower_(Vector::Zero(size())),
      good_(size(), false) {}

const Vector& LowerBounds::prove(std::optional<Index> counted) {
    if (zeros_ < size() && counted >= size() && counted <= vectors_.cols() &&
        counter_.family().size() <= most_beside_another) {
        prove_below(vectors_.leftCols(*counted), 0.05);
        prove_by_gaps();
    }
    prove_each(!counted);
    for (Index j = 1; j < size(); ++j)
        lower_[j] = std::max(lower_[j], lower_[j - 1]);
    return lower_;
}

const LowerGuesses& LowerBounds::guesses() {
    if (guesses_.values.size() == 0)
        guesses_ = lower_guesses(counter_.family(), vectors(), upper_, options_.linear_solver);
    return guesses_;
}

/// At most so many eigenvalues lie below s: a bound of all behind them.
void LowerBounds::record(double s, Index most) {
    for (Index i = most; i < size(); ++i)
        lower_[i] = std::max(lower_[i], s);
}

std::optional<Index> LowerBounds::count(double s) {
    const auto counted = counter_.at(s);
    counts_.emplace_back(s, counted);
    if (counted)
        record(s, *counted);
    return counted;
}

/// From the last count, of as many as there are vectors. Stops at a bound for which vectors that
/// are not exact lose more than this share of its width.
void LowerBounds::prove_below(const DenseMatrix& vectors, double share) {
    const double t = counter_.counted_at();
    double s = t / 2;
    const LehmannBounds bounds(counter_, s, vectors);
    auto ratios = bounds.ratios(s);
    // the bound of eigenvalue j is the s where t - s = way[j]; ways and their slopes at s
    Vector way, slopes = Vector::Zero(vectors.cols());
    if (ratios)
        way = (t - s) * ratios->most;
    for (Index j = std::min<Index>(size(), vectors.cols()) - 1; ratios && j >= zeros_; --j) {
        for (int step = 0; step < 4; ++step) {
            const double best = s + (t - s - way[j]) / (1 + slopes[j]), width = upper_[j] - best;
            if (way[j] < t - s && best - s <= 0.03 * width) {
                good_[j] = good_[j] || way[j] - (t - s) * ratios->least[j] <= share * width;
                break;
            }
            const double next = best - 0.01 * std::max(width, 1e-9 * upper_[j]);
            ratios = next > 0 ? bounds.ratios(next) : std::nullopt;
            if (!ratios)
                break;
            record(next, static_cast<Index>((ratios->most.array() >= 1).count()));
            slopes = ((t - next) * ratios->most - way) / (next - s);
            s = next;
            way = (t - s) * ratios->most;
        }
        if (!good_[j])
            return;
    }
}

/// From a count in a gap between those whose bounds may be better and others: where vectors that
/// are not exact lose least.
void LowerBounds::prove_by_gaps() {
    for (Index j = size() - 1; j >= zeros_; --j) {
        if (good_[j])
            continue;
        double least = std::numeric_limits<double>::infinity(), middle = 0;
        Index others = 0;
        for (Index i = j + 1; i < size() && good_[i]; ++i) {
            const double gap = lower_[i] - upper_[i - 1], way = lower_[i] - gap / 2 - upper_[j];
            if (const double loss = way * (1 + 2 * way / gap); gap > 0 && loss < least) {
                least = loss;
                middle = lower_[i] - gap / 2;
                others = i;
            }
        }
        if (others == 0 || count(middle) != others)
            return;
        prove_below(vectors_.leftCols(others), 0.1);
        if (!good_[j])
            return;
    }
}

/// Counts grow with s: the smallest s known to have more than j below it, at most the upper bound
/// and the limit of counts.
double LowerBounds::limit(Index j) const {
    double result = std::min(upper_[j], counter_.family().limit());
    for (const auto& [s, most] : counts_)
        if (!most || *most > j)
            result = std::min(result, s);
    return result;
}

/// Whether a count slightly below a guess proves the bound of eigenvalue j. Where widths are as
/// small as rounding, counts fail nearby.
bool LowerBounds::prove_near(double guess, Index j) {
    const double width = std::max(upper_[j] - guess, 1e-11 * upper_[j]),
                 farthest = std::max(0.1 * width, 1e-4 * upper_[j]);
    for (double step = 1e-2 * width; step <= farthest; step *= 10) {
        const double s = guess - step;
        const auto counted = s < limit(j) ? count(s) : std::nullopt;
        if (counted && *counted <= j)
            return true;
    }
    return false;
}

void LowerBounds::bisect(Index j) {
    constexpr int most_bisections = 6;
    constexpr double fine = 0.35; // of the width
    for (int step = 0; step < most_bisections; ++step) {
        const double low = lower_[j], high = limit(j);
        if (high - low <= fine * (upper_[j] - low))
            return;
        count((low + high) / 2);
    }
}

/// Each bound, and those that follow it closely. Where simplices are nearly too large, all guesses
/// fail if one does.
void LowerBounds::prove_each(bool are_too_large) {
    bool by_guesses = true;
    constexpr double cluster = 1e-2; // of the width
    for (Index j = size() - 1; j >= zeros_; --j) {
        if (good_[j])
            continue;
        const Vector& values = by_guesses ? guesses().values : upper_;
        const double width = cluster * (upper_[j] - values[j]);
        if (lower_[j] >= values[j] - 2 * width)
            continue;
        Index first = j;
        while (first > zeros_ && values[j] - values[first - 1] <= width)
            --first;
        if (options_.progress)
            options_.progress("a lower bound");
        if (by_guesses && prove_near(values[first], first))
            continue;
        by_guesses = !are_too_large;
        bisect(first);
    }
}

} // namespace polydec
