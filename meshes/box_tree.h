// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <vector>

namespace polydec {

/// Boxes in R^N, in a tree of boxes around them: each is halved where the middles along its longest
/// side have their median (Bentley 1975). Any number, also none; time O(n log n).
class BoxTree {
public:
    /// Each box by its least and its largest coordinates, a row of both.
    BoxTree(const Points& least, const Points& largest);

    /// The boxes that meet this one, and some beside them, ascending.
    std::vector<Index> around(const Eigen::RowVectorXd& least,
                              const Eigen::RowVectorXd& largest) const;

    struct Node {
        Index begin, end;      ///< of its boxes in order()
        Index left, right = 0; ///< 0 for a leaf
    };

    const std::vector<Node>& nodes() const { return nodes_; } ///< the first is around all
    const std::vector<Index>& order() const { return order_; }

    /// N least coordinates of a node, then N largest.
    const double* box(Index node) const { return boxes_.data() + 2 * N_ * node; }

    /// Between two boxes, and from one corner to the other of the box around both.
    double squared_gap(const double* a, const double* b) const;
    double squared_span(const double* a, const double* b) const;

private:
    Index add_node(const Points& least, const Points& largest, Index begin, Index end);
    void visit(Index node, const double* box, std::vector<Index>& found) const;

    Index N_;
    std::vector<Index> order_;
    std::vector<Node> nodes_;
    std::vector<double> boxes_;
};

} // namespace polydec
