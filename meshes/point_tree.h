// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"
#include "complex/disjoint_sets.h"
#include "meshes/box_tree.h"

#include <limits>
#include <vector>

namespace polydec {

/// Finite points in units of their own: moved to begin at 0, the largest coordinate is of the order
/// of 1, so that no square overflows or vanishes that matters. Equal points stay equal.
struct OwnUnits {
    explicit OwnUnits(const Points& given);

    /// A length in these units.
    double scaled(double length) const { return length / 2 / half; }

    Points points;
    double half; ///< of the unit, a power of 2
};

/// Joins points that are at most this far apart, and so also those between which others form a
/// chain of such steps. Coordinates are as of OwnUnits. Time O(n log n) however many points are
/// near each other, but for clusters just beyond the length.
void join_near(const Points& points, double length, DisjointSets& sets);

/// Points of R^N in a BoxTree; coordinates are as of OwnUnits. Any number of points, also none.
class PointTree {
public:
    explicit PointTree(const Points& points);

    /// The points at most this far from a simplex, given by its k+1 corners, k >= 0, ascending;
    /// without some that are none of the question.
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

/// Squared distance from a point to a simplex of any dimension k <= N, which may be flat; where
/// that is larger than `most`, some number that is too.
double squared_distance(const Eigen::RowVectorXd& point, const Points& simplex,
                        double most = std::numeric_limits<double>::infinity());

} // namespace polydec
