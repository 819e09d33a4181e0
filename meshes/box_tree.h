// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <vector>

namespace polydec {

/// Boxes in R^N in a tree of bounding boxes: each node is split at the median of the centers along
/// its longest side (Bentley 1975). Any number, also 0; time O(n log n).
class BoxTree {
public:
    /// Each box is a row of its least and a row of its largest coordinates.
    BoxTree(const Points& least, const Points& largest);

    /// All boxes that meet this one, and possibly some others, ascending.
    std::vector<Index> around(const Eigen::RowVectorXd& least,
                              const Eigen::RowVectorXd& largest) const;

    struct Node {
        Index begin, end;      ///< range of its boxes in order()
        Index left, right = 0; ///< 0 for a leaf
    };

    const std::vector<Node>& nodes() const { return nodes_; } ///< the first bounds all boxes
    const std::vector<Index>& order() const { return order_; }

    /// The N least, then the N largest coordinates of a node.
    const double* box(Index node) const { return boxes_.data() + 2 * N_ * node; }

    /// The squared distance between two boxes, and the squared diagonal of the box around both.
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
