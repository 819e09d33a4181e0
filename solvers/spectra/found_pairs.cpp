// SPDX-License-Identifier: MIT
#include "solvers/spectra/found_pairs.h"

#include "base/errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace polydec {

namespace {

/// Multiplets split by 1e-2 on real meshes and by 1e-14 on symmetric ones; two values further apart
/// than this are no copies of one.
constexpr double relative_gap = 1e-6;

/// What a radius may be at most of its value, or of the distance to the next ones.
constexpr double largest_radius_share = 1e-6;

/// Smaller radii than this share are not striven for.
constexpr double fine_share = 1e-9;

/// Consecutive values that cannot be told apart.
struct Group {
    Index begin, end;
    double radius;
};

/// What the squares of singular values of normalized columns are at least (Gershgorin).
double smallest_square(const DenseMatrix& gram, Index begin, Index end) {
    constexpr double rounding = 1e-12;
    const auto block = gram.block(begin, begin, end - begin, end - begin);
    double smallest = 1;
    for (Index i = 0; i < block.rows(); ++i) {
        double others = 0;
        for (Index j = 0; j < block.cols(); ++j)
            if (j != i)
                others += std::abs(block(i, j)) / std::sqrt(block(i, i) * block(j, j));
        smallest = std::min(smallest, 1 - others - rounding);
    }
    return smallest;
}

/// The first values of a semidefinite matrix, as long as the sum of their energies, which as many
/// eigenvalues do not exceed, says more than their residuals.
Group zeros(const Vector& energies, const Vector& radii, const DenseMatrix& gram) {
    Group group{0, 0, 0};
    double sum = 0;
    for (Index i = 0; i < energies.size(); ++i) {
        sum += energies[i];
        if (!(sum < radii[i] / 2))
            break;
        group = {0, i + 1, 2 * sum};
    }
    return smallest_square(gram, 0, group.end) >= 0.5 ? group : Group{0, 0, 0};
}

/// The radii of all together from those of each alone.
Vector joint_radii(const Vector& values, const Vector& radii, const Vector& energies,
                   const DenseMatrix& gram) {
    const auto radius = [&](Index begin, Index end) {
        if (end - begin == 1)
            return radii[begin];
        const double square = smallest_square(gram, begin, end);
        return square > 0 ? radii.segment(begin, end - begin).norm() / std::sqrt(square)
                          : std::numeric_limits<double>::infinity();
    };
    std::vector<Group> groups;
    const Group first = zeros(energies, radii, gram);
    if (first.end > 0)
        groups.push_back(first);
    for (Index i = first.end; i < values.size(); ++i) {
        groups.push_back({i, i + 1, radii[i]});
        while (groups.size() > 1) {
            const Group last = groups.back();
            Group& before = groups[groups.size() - 2];
            const double end_before = values[before.end - 1] + before.radius;
            if (end_before < values[last.begin] - last.radius)
                break;
            before = {before.begin, last.end, radius(before.begin, last.end)};
            groups.pop_back();
        }
    }
    Vector joint(values.size());
    for (const Group& group : groups)
        joint.segment(group.begin, group.end - group.begin).setConstant(group.radius);
    return joint;
}

} // namespace

void FoundPairs::take(const DenseMatrix& vectors, const std::vector<Enclosure>& enclosures) {
    const Index before = count(), after = before + static_cast<Index>(vectors.cols());
    vectors_.conservativeResize(Eigen::NoChange, after);
    vectors_.rightCols(vectors.cols()) = vectors;
    for (Vector* const list : {&values_, &lone_radii_, &doubts_, &energies_, &residuals_})
        list->conservativeResize(after);
    for (Index i = before; i < after; ++i) {
        values_[i] = enclosures[i - before].value;
        lone_radii_[i] = enclosures[i - before].radius;
        doubts_[i] = enclosures[i - before].doubt;
        energies_[i] = enclosures[i - before].energy;
        residuals_[i] = enclosures[i - before].residual;
    }
    std::vector<Index> order(after);
    std::iota(order.begin(), order.end(), Index{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return values_[a] < values_[b]; });
    keep(order);
}

void FoundPairs::keep(const std::vector<Index>& chosen) {
    vectors_ = DenseMatrix(vectors_(Eigen::all, chosen));
    for (Vector* const list : {&values_, &lone_radii_, &doubts_, &energies_, &residuals_})
        *list = Vector((*list)(chosen));
    radii_ = joint_radii(values_, lone_radii_, energies_, products_(vectors_, vectors_));
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
        throw InvalidInput(fmt::format("{} vectors of {} numbers are to be started with: expected "
                                       "at most {} of as many finite ones",
                                       vectors.cols(), vectors.rows(), pencil.size()));
    std::vector<Index> lengthy;
    for (Index i = 0; i < vectors.cols(); ++i)
        if (vectors.col(i).norm() > 0)
            lengthy.push_back(i);
    vectors = DenseMatrix(vectors(Eigen::all, lengthy)).colwise().normalized();
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
                "eigenvalue {} cannot be told from its neighbors: it is {:.6g} to within {:.3g}, "
                "since rounding beside the largest one, about {:.3g}, hides it; improve or remove "
                "cells that are very much smaller or flatter than others",
                i, unit * pairs.values()[i], unit * pairs.radii()[i], unit * norm));
        if (!pairs.is_accurate(i, largest_radius_share))
            rough.push_back(i);
    }
    return rough;
}

} // namespace polydec
