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

    std::vector<std::uint64_t> cells(static_cast<std::size_t>(points.rows()), 0);
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
    const PointTree tree(points(near, Eigen::all));
    DisjointSets of_near(static_cast<Index>(near.size()));
    tree.join_all(0, length * length, of_near);
    const auto firsts = of_near.firsts();
    for (std::size_t i = 0; i < near.size(); ++i)
        sets.join(near[static_cast<std::size_t>(firsts[i])], near[i]);
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
struct PointTree::Piece {
    explicit Piece(Points given) : corners(std::move(given)), box(2 * corners.cols()) {
        box << corners.colwise().minCoeff(), corners.colwise().maxCoeff();
    }

    Points corners;
    Eigen::RowVectorXd box;
};

struct PointTree::Near {
    Piece simplex;
    double square; // of the length
    const std::vector<Index>& without;
    std::vector<Index> found = {};
};

std::vector<Index> PointTree::near(const Points& simplex, double length,
                                   const std::vector<Index>& without) const {
    Near near{Piece(simplex), length * length, without};
    if (!tree_.nodes().empty())
        search(near, 0, near.simplex);
    std::sort(near.found.begin(), near.found.end());
    near.found.erase(std::unique(near.found.begin(), near.found.end()), near.found.end());
    return std::move(near.found);
}

/// A piece much larger than the box is halved before it, so that boxes along a long edge are few;
/// one of many corners is not, whose pieces, until all edges are halved, would be too many.
void PointTree::search(Near& near, Index node, const Piece& piece) const {
    if (tree_.squared_gap(tree_.box(node), piece.box.data()) > near.square)
        return;
    const auto& [begin, end, left, right] = tree_.nodes()[node];
    if (left == 0)
        return search_leaf(near, node);
    const double extent = tree_.squared_span(piece.box.data(), piece.box.data());
    constexpr double much = 16; // of squares
    const double own = tree_.squared_span(tree_.box(node), tree_.box(node));
    constexpr Index many = 4;
    if (extent <= near.square || extent <= much * own || piece.corners.rows() > many) {
        search(near, left, piece);
        search(near, right, piece);
        return;
    }
    const Points& corners = piece.corners;
    Index a = 0, b = 1; // the longest edge
    for (Index i = 0; i < corners.rows(); ++i)
        for (Index j = i + 1; j < corners.rows(); ++j)
            if ((corners.row(i) - corners.row(j)).squaredNorm() >
                (corners.row(a) - corners.row(b)).squaredNorm()) {
                a = i;
                b = j;
            }
    for (const Index replaced : {a, b}) {
        Points half = corners;
        half.row(replaced) = 0.5 * (corners.row(a) + corners.row(b));
        search(near, node, Piece(std::move(half)));
    }
}

void PointTree::search_leaf(Near& near, Index node) const {
    const BoxTree::Node& leaf = tree_.nodes()[node];
    const auto N = points_.cols();
    const auto& without = near.without;
    const double* const around = near.simplex.box.data();
    for (Index i = leaf.begin; i < leaf.end; ++i) {
        const double* const point = points_.row(i).data();
        double gap = 0; // to the box
        for (Index axis = 0; axis < N; ++axis)
            gap = std::max({gap, around[axis] - point[axis], point[axis] - around[N + axis]});
        if (gap * gap <= near.square &&
            std::find(without.begin(), without.end(), tree_.order()[i]) == without.end() &&
            squared_distance(points_.row(i), near.simplex.corners, near.square) <= near.square)
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
