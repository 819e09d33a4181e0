// SPDX-License-Identifier: MIT
#include "backends/spectra/found_pairs.h"

#include "base/errors.h"
#include "base/lists.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace polydec {

namespace {

/// Multiplets split by 1e-2 on real meshes and by 1e-14 on symmetric ones; two values further apart
/// than this are no copies of one.
constexpr double relative_gap = 1e-6;

/// What a radius may be at most of its value, or of the distance to the next ones.
constexpr double largest_radius_share = 1e-6;

/// Smaller radii than this share are not striven for.
constexpr double fine_share = 1e-9;

/// Puts consecutive values that cannot be told apart into groups, with radii of all of each.
class Grouping {
public:
    /// `gram` is of the vectors.
    Grouping(const Vector& values, const Vector& radii, const DenseMatrix& gram)
        : values_(values),
          radii_(radii),
          scale_(gram.diagonal().cwiseSqrt().cwiseInverse()),
          gram_(gram),
          others_(Vector::Zero(values.size())) {}

    Vector joint_radii(const Vector& energies) {
        put_zeros(energies);
        for (Index i = groups_.empty() ? 0 : groups_.back().end; i < values_.size(); ++i) {
            groups_.push_back({i, i + 1, radii_[i] * radii_[i], radii_[i]});
            while (groups_.size() > 1 && meet(groups_[groups_.size() - 2], groups_.back()))
                merge_last();
        }
        Vector joint(values_.size());
        for (const Group& group : groups_)
            joint.segment(group.begin, group.end - group.begin).setConstant(group.radius);
        return joint;
    }

private:
    struct Group {
        Index begin, end;
        double squares; // sum of those of the radii of each alone
        double radius;
    };

    bool meet(const Group& before, const Group& last) const {
        return values_[before.end - 1] + before.radius >= values_[last.begin] - last.radius;
    }

    /// The last two become one. What others share of a vector is added up for those of one group.
    void merge_last() {
        const Group last = groups_.back();
        groups_.pop_back();
        Group& group = groups_.back();
        couple(group.begin, group.end, last.end);
        group.end = last.end;
        group.squares += last.squares;
        const double square = smallest_square(group.begin, group.end);
        group.radius = square > 0 ? std::sqrt(group.squares / square)
                                  : std::numeric_limits<double>::infinity();
    }

    void couple(Index begin, Index middle, Index end) {
        for (Index j = middle; j < end; ++j)
            for (Index i = begin; i < middle; ++i) {
                const double share = std::abs(gram_(i, j)) * scale_[i] * scale_[j];
                others_[i] += share;
                others_[j] += share;
            }
    }

    /// What the squares of singular values of normalized columns are at least (Gershgorin).
    double smallest_square(Index begin, Index end) const {
        constexpr double rounding = 1e-12;
        return 1 - others_.segment(begin, end - begin).maxCoeff() - rounding;
    }

    /// The first values of a semidefinite matrix, as long as the sum of their energies, which as
    /// many eigenvalues do not exceed, says more than their residuals.
    void put_zeros(const Vector& energies) {
        double sum = 0;
        Group zeros{0, 0, 0, 0};
        for (Index i = 0; i < values_.size(); ++i) {
            sum += energies[i];
            if (!(sum < radii_[i] / 2))
                break;
            couple(0, i, i + 1);
            zeros = {0, i + 1, zeros.squares + radii_[i] * radii_[i], 2 * sum};
        }
        if (zeros.end == 0)
            return;
        if (smallest_square(0, zeros.end) >= 0.5)
            groups_.push_back(zeros);
        else
            others_.setZero();
    }

    const Vector &values_, &radii_;
    Vector scale_; // of vectors to length 1
    const DenseMatrix& gram_;
    Vector others_; // of each vector, what those of its group have in common with it
    std::vector<Group> groups_;
};

} // namespace

void FoundPairs::take(const DenseMatrix& vectors, const std::vector<Enclosure>& enclosures) {
    const Index before = count(), after = before + static_cast<Index>(vectors.cols());
    vectors_.conservativeResize(Eigen::NoChange, after);
    vectors_.rightCols(vectors.cols()) = vectors;
    gram_.conservativeResize(after, after);
    gram_.rightCols(vectors.cols()) = products_(vectors_, vectors);
    gram_.bottomLeftCorner(vectors.cols(), before) =
        gram_.topRightCorner(before, vectors.cols()).transpose();
    for (Vector* const list : {&values_, &lone_radii_, &doubts_, &energies_, &residuals_})
        list->conservativeResize(after);
    for (Index i = before; i < after; ++i) {
        values_[i] = enclosures[i - before].value;
        lone_radii_[i] = enclosures[i - before].radius;
        doubts_[i] = enclosures[i - before].doubt;
        energies_[i] = enclosures[i - before].energy;
        residuals_[i] = enclosures[i - before].residual;
    }
    std::vector<Index> order = numbers_below(after);
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return values_[a] < values_[b]; });
    keep(order);
}

void FoundPairs::keep(const std::vector<Index>& chosen) {
    vectors_ = DenseMatrix(vectors_(Eigen::indexing::all, chosen));
    for (Vector* const list : {&values_, &lone_radii_, &doubts_, &energies_, &residuals_})
        *list = Vector((*list)(chosen));
    gram_ = DenseMatrix(gram_(chosen, chosen));
    radii_ = Grouping(values_, lone_radii_, gram_).joint_radii(energies_);
}

/// Distance from value i to the nearest one that its interval does not meet; 0 if there is none.
double FoundPairs::distance_to_others(Index i) const {
    const auto touch = [&](Index j) { // neighbors j and j + 1
        return values_[j] + radii_[j] >= values_[j + 1] - radii_[j + 1];
    };
    Index low = i, high = i;
    while (low > 0 && touch(low - 1))
        --low;
    while (high + 1 < count() && touch(high))
        ++high;
    constexpr double none = std::numeric_limits<double>::infinity();
    const double below = low > 0 ? values_[i] - values_[low - 1] : none;
    const double above = high + 1 < count() ? values_[high + 1] - values_[i] : none;
    const double distance = std::min(below, above);
    return distance < none ? distance : 0;
}

bool FoundPairs::is_accurate(Index i, double share) const {
    return radii_[i] <= share * std::max(std::abs(values_[i]), distance_to_others(i));
}

bool FoundPairs::is_fine(Index i) const {
    return radii_[i] <= fine_share * std::max(std::abs(values_[i]), small_) ||
           lone_radii_[i] <= 2 * doubts_[i];
}

std::vector<Index> FoundPairs::all(bool fine) const {
    std::vector<Index> chosen;
    for (Index i = 0; i < count(); ++i)
        if (is_fine(i) == fine)
            chosen.push_back(i);
    return chosen;
}

Index FoundPairs::fine_before(Index count) const {
    Index i = 0;
    while (i < count && is_fine(i))
        ++i;
    return i;
}

Index FoundPairs::gap_behind(Index count) const {
    for (Index i = count; i < this->count(); ++i) {
        const double size_here = std::max(std::abs(values_[i]), std::abs(values_[i - 1]));
        const double unsure = radii_[i] + radii_[i - 1];
        if (values_[i] - values_[i - 1] > std::max(relative_gap * size_here, 4 * unsure))
            return i;
    }
    return -1;
}

void take_kernel(FoundPairs& pairs, const ScaledPencil& pencil, const DenseMatrix& vectors) {
    if (vectors.cols() == 0)
        return;
    const DenseMatrix Y = pencil.scaled(vectors).colwise().normalized();
    pairs.take(Y, pencil.enclose(Y));
}

void take_proved(FoundPairs& pairs, const ScaledPencil& pencil, DenseMatrix vectors) {
    if (vectors.cols() == 0)
        return;
    if (vectors.rows() != pencil.size() || vectors.cols() > pencil.size() || !vectors.allFinite())
        throw InvalidInput(fmt::format("{} start vectors of {} numbers: expected at most {} "
                                       "vectors of the same number of finite entries",
                                       vectors.cols(), vectors.rows(), pencil.size()));
    std::vector<Index> lengthy;
    for (Index i = 0; i < vectors.cols(); ++i)
        if (vectors.col(i).norm() > 0)
            lengthy.push_back(i);
    vectors = DenseMatrix(vectors(Eigen::indexing::all, lengthy)).colwise().normalized();
    pairs.take(vectors, pencil.enclose(vectors));
    std::vector<Index> good;
    for (Index i = 0; i < pairs.count(); ++i)
        if (pairs.is_accurate(i, largest_radius_share)) // copies of one are not
            good.push_back(i);
    pairs.keep(good);
}

std::vector<Index> rough_values(const FoundPairs& pairs, double norm, double unit, Index count) {
    std::vector<Index> rough;
    for (Index i = 0; i < count; ++i) {
        if (!pairs.is_accurate(i, 1))
            throw SolverFailure(fmt::format(
                "eigenvalue {} cannot be separated from its neighbors: it is {:.6g} to within "
                "{:.3g}, because of rounding errors relative to the largest one, about {:.3g}; "
                "improve or remove cells that are much smaller or flatter than others",
                i, unit * pairs.values()[i], unit * pairs.radii()[i], unit * norm));
        if (!pairs.is_accurate(i, largest_radius_share))
            rough.push_back(i);
    }
    return rough;
}

} // namespace polydec
