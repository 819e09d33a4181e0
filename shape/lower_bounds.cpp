// SPDX-License-Identifier: MIT
#include "shape/lower_bounds.h"

#include "shape/lehmann_bounds.h"

#include <algorithm>
#include <limits>

namespace polydec {

LowerBounds::LowerBounds(FamilyCounter& counter, const ShapeSpectrumOptions& options,
                         int domain_dimension, Vector upper, Index zeros, DenseMatrix vectors)
    : counter_(counter),
      options_(options),
      domain_dimension_(domain_dimension),
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
        guesses_ = lower_guesses(counter_.family(), vectors(), upper_, options_.linear_solver,
                                 domain_dimension_);
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

/// Whether a count slightly below a guess proves the bound of eigenvalue j.
bool LowerBounds::prove_near(double guess, Index j) {
    for (const double share : {1e-2, 0.1}) {
        const double s = guess - share * std::max(upper_[j] - guess, 1e-11 * upper_[j]);
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
