// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"
#include "complex/disjoint_sets.h"
#include "meshes/box_tree.h"

#include <limits>
#include <vector>

namespace polydec {

/// Finite points, translated and scaled: coordinates begin at 0 and the largest is of order 1, so
/// that no relevant square overflows or underflows. Equal points stay equal.
struct OwnUnits {
    explicit OwnUnits(const Points& given);

    /// A length in the scaled unit.
    double scaled(double length) const { return length / 2 / half; }

    Points points;
    double half; ///< half the unit, a power of 2
};

/// Joins points at most `length` apart, and points connected by chains of such steps. Coordinates
/// are as in OwnUnits. Time O(n log n) for any density of points, except for clusters just beyond
/// the length.
void join_near(const Points& points, double length, DisjointSets& sets);

/// Points of R^N in a BoxTree; coordinates are as in OwnUnits. Any number of points, also 0.
class PointTree {
public:
    explicit PointTree(const Points& points);

    /// The points at most `length` from a simplex, given by its k+1 corners, k >= 0; ascending,
    /// excluding the points in `without`.
    std::vector<Index> near(const Points& simplex, double length,
                            const std::vector<Index>& without = {}) const;

private:
    struct Near; // a search, and what it has found

    friend void join_near(const Points& points, double length, DisjointSets& sets);

    /// Boxes no larger than the length are joined as a whole.
    void join_all(Index node, double square, DisjointSets& sets) const;
    void join_across(Index a, Index b, double square, DisjointSets& sets) const;
    void join_leaves(Index a, Index b, double square, DisjointSets& sets) const;
    void search(Near& near, Index node) const;
    void search_leaf(Near& near, Index leaf) const;

    BoxTree tree_;
    Points points_; // in its order
};

/// Squared distance from a point to a simplex of any dimension k <= N, which may be flat. If it
/// exceeds `most`, the result is some number above `most`.
double squared_distance(const Eigen::RowVectorXd& point, const Points& simplex,
                        double most = std::numeric_limits<double>::infinity());

} // namespace polydec
