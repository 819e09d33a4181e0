// SPDX-License-Identifier: MIT
#include "meshes/point_tree.h"

#include "base/decompositions.h"
#include "meshes/rearrange.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace polydec {

OwnUnits::OwnUnits(const Points& given) : points(given / 2), half(1) {
    if (points.size() == 0)
        return;
    const Eigen::RowVectorXd least = points.colwise().minCoeff();
    points.rowwise() -= least; // of halves, which does not overflow
    if (const double extent = points.maxCoeff(); extent > 0)
        half = std::ldexp(1.0, std::ilogb(extent));
    points /= half;
}

PointTree::PointTree(const Points& points) : tree_(points, points), points_(points) {
    for (Index i = 0; i < points.rows(); ++i)
        points_.row(i) = points.row(tree_.order()[i]);
}

namespace {

/// The points that may have others at most this far from them, ascending: those that share a cell
/// of a grid, or lie as near to its walls. Most points of a mesh do not, and need no tree.
std::vector<Index> crowded(const Points& points, double length) {
    const auto axes = std::min<Index>(static_cast<Index>(points.cols()), 63);
    const int digits = std::min(axes > 0 ? 63 / axes : 1, 21); // of the number of a cell, each axis
    constexpr double roomy = 256;      // of 3 axes, one point in 43 is near to a wall
    constexpr double apart = 0.381966; // from walls; no ratio of sides puts grids of points there
    constexpr double rounding = 1e-8;  // of places, which are below 2^22
    const double extent = points.size() > 0 ? points.maxCoeff() : 0;
    const double side = std::max({roomy * length, extent / (std::ldexp(1.0, digits) - 1),
                                  std::numeric_limits<double>::min()});
    const double margin = length / side + rounding;

    std::vector<std::uint64_t> cells(points.rows(), 0);
    std::vector<bool> found(cells.size(), false);
    for (Index i = 0; i < points.rows(); ++i)
        for (Index axis = 0; axis < axes; ++axis) {
            const double place = points(i, axis) / side + apart, cell = std::floor(place);
            cells[i] = cells[i] << digits | static_cast<std::uint64_t>(cell);
            if (place - cell <= margin || place - cell >= 1 - margin)
                found[i] = true;
        }
    const auto order = ascending_order(cells);
    for (std::size_t i = 1; i < order.size(); ++i)
        if (cells[order[i]] == cells[order[i - 1]])
            found[order[i]] = found[order[i - 1]] = true;

    std::vector<Index> result;
    for (Index i = 0; i < points.rows(); ++i)
        if (found[i])
            result.push_back(i);
    return result;
}

} // namespace

void join_near(const Points& points, double length, DisjointSets& sets) {
    const auto near = crowded(points, length);
    if (near.empty())
        return;
    const PointTree tree(points(near, Eigen::indexing::all));
    DisjointSets of_near(static_cast<Index>(near.size()));
    tree.join_all(0, length * length, of_near);
    const auto firsts = of_near.firsts();
    for (std::size_t i = 0; i < near.size(); ++i)
        sets.join(near[firsts[i]], near[i]);
}

void PointTree::join_all(Index node, double square, DisjointSets& sets) const {
    const auto& [begin, end, left, right] = tree_.nodes()[node];
    if (tree_.squared_span(tree_.box(node), tree_.box(node)) <= square) {
        for (Index i = begin + 1; i < end; ++i)
            sets.join(tree_.order()[begin], tree_.order()[i]);
    } else if (left == 0) {
        join_leaves(node, node, square, sets);
    } else {
        join_all(left, square, sets);
        join_all(right, square, sets);
        join_across(left, right, square, sets);
    }
}

/// Boxes no larger than the length are joined within before.
void PointTree::join_across(Index a, Index b, double square, DisjointSets& sets) const {
    const double *const box_a = tree_.box(a), *const box_b = tree_.box(b);
    if (tree_.squared_gap(box_a, box_b) > square)
        return;
    const BoxTree::Node &in = tree_.nodes()[a], &other = tree_.nodes()[b];
    const Index first_a = tree_.order()[in.begin], first_b = tree_.order()[other.begin];
    const double own_a = tree_.squared_span(box_a, box_a);
    const double own_b = tree_.squared_span(box_b, box_b);
    if (tree_.squared_span(box_a, box_b) <= square) {
        sets.join(first_a, first_b);
        return;
    }
    if (own_a <= square && own_b <= square &&
        sets.find(first_a).element == sets.find(first_b).element)
        return;
    const bool is_leaf_a = in.left == 0, is_leaf_b = other.left == 0;
    if (is_leaf_a && is_leaf_b) {
        join_leaves(a, b, square, sets);
    } else if (is_leaf_b || (!is_leaf_a && own_a >= own_b)) {
        join_across(in.left, b, square, sets);
        join_across(in.right, b, square, sets);
    } else {
        join_across(a, other.left, square, sets);
        join_across(a, other.right, square, sets);
    }
}

void PointTree::join_leaves(Index a, Index b, double square, DisjointSets& sets) const {
    const BoxTree::Node &in = tree_.nodes()[a], &other = tree_.nodes()[b];
    for (Index i = in.begin; i < in.end; ++i)
        for (Index j = other.begin; j < other.end; ++j)
            if (i != j && (points_.row(i) - points_.row(j)).squaredNorm() <= square)
                sets.join(tree_.order()[i], tree_.order()[j]);
}

/// A part of a simplex, in its box.
struct PointTree::Near {
    const Points& simplex;
    Eigen::RowVectorXd box, middle; // of the simplex
    double length;
    const std::vector<Index>& without;
    std::vector<Index> found = {};

    /// Whether a plane orthogonal to the line from the middle to a point separates the simplex from
    /// this point by more than the length. A cheap test that excludes nearly all points.
    bool is_separate_from(const double* point) const {
        constexpr double rounding = 1e-12; // of coordinates, which are below 4
        double gap = std::numeric_limits<double>::infinity(), squared = 0;
        for (Eigen::Index axis = 0; axis < middle.size(); ++axis)
            squared += (point[axis] - middle[axis]) * (point[axis] - middle[axis]);
        for (Eigen::Index i = 0; i < simplex.rows(); ++i) {
            double along = 0;
            for (Eigen::Index axis = 0; axis < middle.size(); ++axis)
                along += (point[axis] - middle[axis]) * (point[axis] - simplex(i, axis));
            gap = std::min(gap, along);
        }
        return gap > (2 * length + rounding) * std::sqrt(squared);
    }
};

std::vector<Index> PointTree::near(const Points& simplex, double length,
                                   const std::vector<Index>& without) const {
    Near near{simplex, Eigen::RowVectorXd(2 * simplex.cols()), simplex.colwise().mean(), length,
              without};
    near.box << simplex.colwise().minCoeff(), simplex.colwise().maxCoeff();
    if (!tree_.nodes().empty())
        search(near, 0);
    std::sort(near.found.begin(), near.found.end());
    return std::move(near.found);
}

/// A simplex much larger than the box has to reach the ball around it, so that few boxes are looked
/// into that are near its own box alone; not one of many corners, where that takes too long.
void PointTree::search(Near& near, Index node) const {
    const double *const box = tree_.box(node), *const around = near.box.data();
    if (tree_.squared_gap(box, around) > near.length * near.length)
        return;
    const auto& [begin, end, left, right] = tree_.nodes()[node];
    if (left == 0)
        return search_leaf(near, node);
    constexpr double much = 16; // of squares
    constexpr Index many = 4;
    const double span = tree_.squared_span(box, box);
    if (tree_.squared_span(around, around) > much * span && near.simplex.rows() <= many) {
        const auto N = points_.cols();
        const Eigen::Map<const Eigen::RowVectorXd> low(box, N), high(box + N, N);
        constexpr double rounding = 1e-9;
        const double reach = (1 + rounding) * (std::sqrt(span) / 2 + near.length);
        if (squared_distance(0.5 * (low + high), near.simplex, reach * reach) > reach * reach)
            return;
    }
    search(near, left);
    search(near, right);
}

void PointTree::search_leaf(Near& near, Index node) const {
    const BoxTree::Node& leaf = tree_.nodes()[node];
    const auto N = points_.cols();
    const auto& without = near.without;
    const double square = near.length * near.length;
    const double* const around = near.box.data();
    for (Index i = leaf.begin; i < leaf.end; ++i) {
        const double* const point = points_.row(i).data();
        double gap = 0; // to the box
        for (Index axis = 0; axis < N; ++axis)
            gap = std::max({gap, around[axis] - point[axis], point[axis] - around[N + axis]});
        if (gap * gap <= square && !near.is_separate_from(point) &&
            std::find(without.begin(), without.end(), tree_.order()[i]) == without.end() &&
            squared_distance(points_.row(i), near.simplex, square) <= square)
            near.found.push_back(tree_.order()[i]);
    }
}

double squared_distance(const Eigen::RowVectorXd& point, const Points& simplex, double most) {
    const auto k = simplex.rows() - 1;
    if (k == 0)
        return (point - simplex.row(0)).squaredNorm();
    const DenseMatrix edges = simplex.bottomRows(k).rowwise() - simplex.row(0);
    const Eigen::ColPivHouseholderQR<DenseMatrix> factors(edges.transpose());
    Eigen::VectorXd shares(k + 1);
    shares.tail(k) = factors.solve((point - simplex.row(0)).transpose());
    shares[0] = 1 - shares.tail(k).sum();
    const double to_hull =
        (simplex.row(0) + shares.tail(k).transpose() * edges - point).squaredNorm();
    const bool is_flat = factors.rank() < k;
    if (to_hull > most || (!is_flat && shares.minCoeff() >= 0))
        return to_hull;
    // outside, or flat: the nearest place is on a facet, from which the point lies outwards
    double least = std::numeric_limits<double>::infinity();
    for (Eigen::Index omitted = 0; omitted <= k; ++omitted) {
        if (!is_flat && shares[omitted] >= 0)
            continue;
        Points facet(k, simplex.cols());
        facet << simplex.topRows(omitted), simplex.bottomRows(k - omitted);
        least = std::min(least, squared_distance(point, facet, most));
    }
    return least;
}

} // namespace polydec
