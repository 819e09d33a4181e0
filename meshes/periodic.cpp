// SPDX-License-Identifier: MIT
#include "meshes/periodic.h"

#include "base/errors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

namespace polydec {

namespace {

/// Vertices by where they are, within a tolerance.
class Places {
public:
    explicit Places(const Points& points)
        : points_(points),
          least_(points.colwise().minCoeff()),
          tolerance_(1e-9 * (points.colwise().maxCoeff() - least_).norm()) {
        for (Index v = 0; v < points.rows(); ++v)
            vertices_[key(points.row(v))].push_back(v);
    }

    /// The vertex at a point, or -1.
    Index at(const Eigen::RowVectorXd& point) const {
        Key around = key(point);
        return search(point, around, 0);
    }

private:
    using Key = std::vector<std::int64_t>;

    Key key(const Eigen::RowVectorXd& point) const {
        Key result;
        for (Index axis = 0; axis < point.size(); ++axis)
            result.push_back(std::llround((point[axis] - least_[axis]) / (4 * tolerance_)));
        return result;
    }

    /// In the boxes of the key and beside it, along the axes from `axis` on.
    Index search(const Eigen::RowVectorXd& point, Key& around, std::size_t axis) const {
        if (axis == around.size()) {
            const auto found = vertices_.find(around);
            if (found == vertices_.end())
                return -1;
            for (const Index v : found->second)
                if ((points_.row(v) - point).norm() <= tolerance_)
                    return v;
            return -1;
        }
        const auto middle = around[axis];
        Index result = -1;
        for (const int step : {0, -1, 1}) {
            around[axis] = middle + step;
            if (result < 0)
                result = search(point, around, axis + 1);
        }
        around[axis] = middle;
        return result;
    }

    const Points& points_;
    Eigen::RowVectorXd least_;
    double tolerance_;
    std::map<Key, std::vector<Index>> vertices_;
};

Index first_of(std::vector<Index>& leaders, Index v) {
    while (leaders[v] != v)
        v = leaders[v] = leaders[leaders[v]];
    return v;
}

/// Of each vertex the first one that translations lead to.
std::vector<Index> glued(const Points& points, const std::vector<Vector>& translations) {
    const Places places(points);
    std::vector<Index> leaders(points.rows());
    for (Index v = 0; v < points.rows(); ++v)
        leaders[v] = v;
    for (const Vector& translation : translations) {
        Index pairs = 0;
        if (translation.size() == points.cols() && translation.allFinite())
            for (Index v = 0; v < points.rows(); ++v) {
                const Index w = places.at(points.row(v) + translation.transpose());
                if (w < 0 || w == v)
                    continue;
                ++pairs;
                const Index a = first_of(leaders, v), b = first_of(leaders, w);
                leaders[std::max(a, b)] = std::min(a, b);
            }
        if (pairs == 0)
            throw InvalidInput(fmt::format("the translation ({}) takes no vertex to another: "
                                           "expected one of {} coordinates along which both ends "
                                           "of the box have the same vertices",
                                           fmt::join(translation, ", "), points.cols()));
    }
    for (Index v = 0; v < points.rows(); ++v)
        leaders[v] = first_of(leaders, v);
    return leaders;
}

[[noreturn]] void refuse(Index cell, const char* what) {
    throw InvalidInput(fmt::format("cell {} {} once the box is glued: expected a simplicial "
                                   "complex; take three cells or more along every translation",
                                   cell, what));
}

/// The edges of the quotient, each with its length; those of the box that become one must be one
/// vector.
void set_edges(PeriodicMesh& mesh) {
    const Mesh& box = mesh.box;
    std::map<std::array<Index, 2>, Eigen::RowVectorXd> vectors;
    const double tolerance =
        1e-8 * (box.points.colwise().maxCoeff() - box.points.colwise().minCoeff()).norm();
    for (Index t = 0; t < box.simplices.rows(); ++t)
        for (Index i = 0; i < box.simplices.cols(); ++i)
            for (Index j = 0; j < box.simplices.cols(); ++j) {
                const Index a = mesh.quotient.simplices(t, i), b = mesh.quotient.simplices(t, j);
                if (a >= b)
                    continue;
                const Eigen::RowVectorXd vector =
                    box.points.row(box.simplices(t, j)) - box.points.row(box.simplices(t, i));
                const auto [place, is_new] = vectors.try_emplace({a, b}, vector);
                if (!is_new && (place->second - vector).norm() > tolerance)
                    refuse(t, "has an edge with the ends of another");
            }
    mesh.quotient.edges.resize(static_cast<Index>(vectors.size()), 2);
    mesh.quotient.lengths.resize(static_cast<Index>(vectors.size()));
    Index row = 0;
    for (const auto& [ends, vector] : vectors) {
        mesh.quotient.edges.row(row) << ends[0], ends[1];
        mesh.quotient.lengths[row++] = vector.norm();
    }
}

void check_simplices(const Simplices& simplices) {
    std::set<std::vector<Index>> seen;
    for (Index t = 0; t < simplices.rows(); ++t) {
        std::vector<Index> corners(simplices.row(t).begin(), simplices.row(t).end());
        std::sort(corners.begin(), corners.end());
        if (std::adjacent_find(corners.begin(), corners.end()) != corners.end())
            refuse(t, "has a vertex twice");
        if (!seen.insert(corners).second)
            refuse(t, "has the corners of another");
    }
}

} // namespace

PeriodicMesh periodic(Mesh box, const std::vector<Vector>& translations) {
    PeriodicMesh result;
    const auto leaders = glued(box.points, translations);
    result.vertices.resize(leaders.size());
    std::vector<Index> kept;
    for (Index v = 0; v < static_cast<Index>(leaders.size()); ++v) {
        if (leaders[v] == v) {
            result.vertices[v] = static_cast<Index>(kept.size());
            kept.push_back(v);
        } else {
            result.vertices[v] = result.vertices[leaders[v]]; // which comes before
        }
    }
    result.points = box.points(kept, Eigen::all);
    result.quotient.vertices = static_cast<Index>(kept.size());
    result.quotient.simplices = box.simplices.unaryExpr(
        [&](Index v) { return result.vertices[static_cast<std::size_t>(v)]; });
    check_simplices(result.quotient.simplices);
    result.box = std::move(box);
    set_edges(result);
    return result;
}

} // namespace polydec
