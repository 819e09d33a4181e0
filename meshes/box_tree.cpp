// SPDX-License-Identifier: MIT
#include "meshes/box_tree.h"

#include "base/lists.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace polydec {

BoxTree::BoxTree(const Points& least, const Points& largest)
    : N_(static_cast<Index>(least.cols())), order_(numbers_below(least.rows())) {
    if (!order_.empty())
        add_node(least, largest, 0, static_cast<Index>(order_.size()));
}

Index BoxTree::add_node(const Points& least, const Points& largest, Index begin, Index end) {
    constexpr Index leaf_size = 8;
    const auto node = static_cast<Index>(nodes_.size());
    nodes_.push_back({begin, end, 0, 0});
    boxes_.resize(boxes_.size() + 2 * static_cast<std::size_t>(N_));
    double* const own = boxes_.data() + 2 * N_ * node;
    std::fill(own, own + N_, std::numeric_limits<double>::infinity());
    std::fill(own + N_, own + 2 * N_, -std::numeric_limits<double>::infinity());
    for (Index i = begin; i < end; ++i)
        for (Index axis = 0; axis < N_; ++axis) {
            own[axis] = std::min(own[axis], least(order_[i], axis));
            own[N_ + axis] = std::max(own[N_ + axis], largest(order_[i], axis));
        }
    if (end - begin <= leaf_size)
        return node;

    Index longest = 0;
    for (Index axis = 1; axis < N_; ++axis)
        if (own[N_ + axis] - own[axis] > own[N_ + longest] - own[longest])
            longest = axis;
    const Index middle = begin + (end - begin) / 2;
    std::vector<std::pair<double, Index>> places;
    places.reserve(static_cast<std::size_t>(end - begin));
    for (Index i = begin; i < end; ++i)
        places.emplace_back(least(order_[i], longest) + largest(order_[i], longest), order_[i]);
    std::nth_element(places.begin(), places.begin() + (middle - begin), places.end());
    std::transform(places.begin(), places.end(), order_.begin() + begin,
                   [](const auto& place) { return place.second; });
    places = {}; // before there are more
    const Index left = add_node(least, largest, begin, middle),
                right = add_node(least, largest, middle, end);
    nodes_[node].left = left;
    nodes_[node].right = right;
    return node;
}

double BoxTree::squared_gap(const double* a, const double* b) const {
    double sum = 0;
    for (Index axis = 0; axis < N_; ++axis) {
        const double gap = std::max({0.0, b[axis] - a[N_ + axis], a[axis] - b[N_ + axis]});
        sum += gap * gap;
    }
    return sum;
}

double BoxTree::squared_span(const double* a, const double* b) const {
    double sum = 0;
    for (Index axis = 0; axis < N_; ++axis) {
        const double span = std::max(a[N_ + axis], b[N_ + axis]) - std::min(a[axis], b[axis]);
        sum += span * span;
    }
    return sum;
}

std::vector<Index> BoxTree::around(const Eigen::RowVectorXd& least,
                                   const Eigen::RowVectorXd& largest) const {
    Eigen::RowVectorXd box(2 * N_);
    box << least, largest;
    std::vector<Index> found;
    if (!nodes_.empty())
        visit(0, box.data(), found);
    std::sort(found.begin(), found.end());
    return found;
}

void BoxTree::visit(Index node, const double* box, std::vector<Index>& found) const {
    if (squared_gap(this->box(node), box) > 0)
        return;
    const auto& [begin, end, left, right] = nodes_[node];
    if (left != 0) {
        visit(left, box, found);
        visit(right, box, found);
        return;
    }
    found.insert(found.end(), order_.begin() + begin, order_.begin() + end);
}

} // namespace polydec
