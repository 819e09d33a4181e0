// SPDX-License-Identifier: MIT
#include "meshes/facet_overlay.h"

#include "base/lists.h"
#include "meshes/box_tree.h"
#include "meshes/point_tree.h"
#include "meshes/polygons.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace polydec {

FacetOverlay::FacetOverlay(const Simplices& triangles,
                           const std::vector<std::vector<Index>>& inside, const Points& points,
                           double length)
    : triangles_(triangles), points_(points), length_(length), vertices_(inside) {
    Points least(triangles.rows(), points.cols()), largest = least;
    for (Index f = 0; f < triangles.rows(); ++f) {
        auto& own = vertices_[f];
        own.insert(own.end(), triangles.row(f).begin(), triangles.row(f).end());
        std::sort(own.begin(), own.end());
        const Points at = points(triangles.row(f).transpose(), Eigen::indexing::all);
        least.row(f) = at.colwise().minCoeff().array() - length;
        largest.row(f) = at.colwise().maxCoeff().array() + length;
    }
    const BoxTree tree(least, largest);
    for (Index f = 0; f < triangles.rows(); ++f)
        for (const Index g : tree.around(least.row(f), largest.row(f)))
            if (f < g)
                overlay(f, g);
    points_ = with_crossings(points, crossings_);
}

std::vector<DividedEdges::Entry> FacetOverlay::on_edges() const {
    std::vector<DividedEdges::Entry> entries;
    auto vertex = static_cast<Index>(points_.rows() - std::ssize(crossings_));
    for (const auto& [a, b, c, d, s, t] : crossings_) {
        entries.push_back({a, b, s, vertex});
        entries.push_back({c, d, t, vertex++});
    }
    return entries;
}

Points FacetOverlay::with_crossings(const Points& points, const std::vector<Crossing>& crossings) {
    Points result = points;
    result.conservativeResize(points.rows() + std::ssize(crossings), Eigen::NoChange);
    for (Index i = 0; i < std::ssize(crossings); ++i) {
        const auto& [a, b, c, d, s, t] = crossings[i];
        result.row(points.rows() + i) = (1 - s) / 2 * points.row(a) + s / 2 * points.row(b) +
                                        (1 - t) / 2 * points.row(c) + t / 2 * points.row(d);
    }
    return result;
}

bool FacetOverlay::lies_in(Index v, Index f) const {
    const auto& own = vertices_[f];
    return std::binary_search(own.begin(), own.end(), v);
}

void FacetOverlay::cross(Index f, Index g, std::vector<Index>& common) {
    for (Index i = 0; i < 3; ++i)
        for (Index j = 0; j < i; ++j)
            for (Index k = 0; k < 3; ++k)
                for (Index l = 0; l < k; ++l) {
                    const std::pair e(triangles_(f, j), triangles_(f, i));
                    const std::pair h(triangles_(g, l), triangles_(g, k));
                    const auto& [first, second] = std::minmax(e, h);
                    cross(first.first, first.second, second.first, second.second, common);
                }
}

/// Edges that share an end, or on one of which an end of the other lies, do not cross.
void FacetOverlay::cross(Index a, Index b, Index c, Index d, std::vector<Index>& common) {
    if (a == c || a == d || b == c || b == d)
        return;
    const Eigen::RowVectorXd u = points_.row(b) - points_.row(a),
                             v = points_.row(d) - points_.row(c),
                             w = points_.row(c) - points_.row(a);
    const double uu = u.squaredNorm(), uv = u.dot(v), vv = v.squaredNorm();
    const double determinant = uu * vv - uv * uv;
    constexpr double parallel = 1e-14;
    if (!(determinant > parallel * uu * vv))
        return;
    const double s = (vv * w.dot(u) - uv * w.dot(v)) / determinant;
    const double t = (uv * w.dot(u) - uu * w.dot(v)) / determinant;
    if (!(s > 0 && s < 1 && t > 0 && t < 1) || (s * u - w - t * v).norm() > length_)
        return;
    const auto touches = [&](Index vertex, Index from, Index to) {
        return squared_distance(points_.row(vertex), points_({from, to}, Eigen::indexing::all)) <=
               length_ * length_;
    };
    if (touches(a, c, d) || touches(b, c, d) || touches(c, a, b) || touches(d, a, b))
        return;
    const auto [at, is_new] = numbers_.try_emplace(
        {a, b, c, d}, static_cast<Index>(points_.rows() + std::ssize(crossings_)));
    if (is_new)
        crossings_.push_back({a, b, c, d, s, t});
    common.push_back(at->second);
}

/// While crossings are found, their points do not stand with the others.
Eigen::RowVectorXd FacetOverlay::point(Index v) const {
    if (v < points_.rows())
        return points_.row(v);
    const auto& [a, b, c, d, s, t] = crossings_[v - points_.rows()];
    return (1 - s) * points_.row(a) + s * points_.row(b);
}

/// Coordinates in the plane of a triangle, from its first corner.
Eigen::MatrixX2d FacetOverlay::in_plane(Index f, const std::vector<Index>& vertices) const {
    const auto [a, b, c] = corners(f);
    Eigen::RowVectorXd u = points_.row(b) - points_.row(a), v = points_.row(c) - points_.row(a);
    u.normalize();
    v -= v.dot(u) * u;
    v.normalize();
    Eigen::MatrixX2d result(std::ssize(vertices), 2);
    for (Index i = 0; i < result.rows(); ++i) {
        const Eigen::RowVectorXd at = point(vertices[i]) - points_.row(a);
        result.row(i) << at.dot(u), at.dot(v);
    }
    return result;
}

void FacetOverlay::overlay(Index f, Index g) {
    std::vector<Index> common;
    for (const Index v : triangles_.row(g))
        if (lies_in(v, f))
            common.push_back(v);
    for (const Index v : triangles_.row(f))
        if (lies_in(v, g) && std::find(common.begin(), common.end(), v) == common.end())
            common.push_back(v);
    cross(f, g, common);
    if (common.size() < 3)
        return;

    // around their middle
    const Eigen::MatrixX2d at = in_plane(f, common);
    const Eigen::RowVector2d middle = at.colwise().mean();
    std::vector<Index> order = numbers_below(common.size());
    std::vector<double> angles;
    for (Index i = 0; i < at.rows(); ++i)
        angles.push_back(std::atan2(at(i, 1) - middle[1], at(i, 0) - middle[0]));
    std::sort(order.begin(), order.end(), [&](Index i, Index j) { return angles[i] < angles[j]; });
    double twice_area = 0, extent = 0;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const auto p = (at.row(order[i]) - middle).eval();
        const auto q = (at.row(order[(i + 1) % order.size()]) - middle).eval();
        twice_area += p[0] * q[1] - p[1] * q[0];
        extent = std::max(extent, p.norm());
    }
    if (!(twice_area > 8 * length_ * extent)) // no more than an edge
        return;
    Common result{f, g, {}};
    for (const Index i : order)
        result.corners.push_back(common[i]);
    commons_.push_back(std::move(result));
}

bool FacetOverlay::is_turned(Index f, Index g) const {
    const auto [a, b, c] = corners(g);
    const Eigen::MatrixX2d at = in_plane(f, {a, b, c});
    const Eigen::RowVector2d u = at.row(1) - at.row(0), v = at.row(2) - at.row(0);
    return u[0] * v[1] < u[1] * v[0];
}

/// With the vertices between two corners that lie on one edge of a triangle.
void FacetOverlay::add_vertices(const Common& common, const DividedEdges& edges,
                                std::vector<Index>& corners_around) const {
    std::vector<std::vector<Index>> chains;
    for (const Index f : {common.f, common.g})
        for (Index i = 0; i < 3; ++i) {
            const Index a = triangles_(f, i), b = triangles_(f, (i + 1) % 3);
            edges.append(a, b, chains.emplace_back());
            chains.back().push_back(b);
        }
    for (std::size_t i = 0; i < common.corners.size(); ++i) {
        const Index from = common.corners[i], to = common.corners[(i + 1) % common.corners.size()];
        corners_around.push_back(from);
        for (const auto& chain : chains) {
            const auto begin = std::find(chain.begin(), chain.end(), from);
            const auto end = std::find(chain.begin(), chain.end(), to);
            if (begin == chain.end() || end == chain.end())
                continue;
            if (begin < end)
                corners_around.insert(corners_around.end(), begin + 1, end);
            else
                corners_around.insert(corners_around.end(), std::make_reverse_iterator(begin),
                                      std::make_reverse_iterator(end + 1));
            break;
        }
    }
}

std::vector<Index> FacetOverlay::outline(Index f, const DividedEdges& edges) const {
    std::vector<Index> around;
    for (Index i = 0; i < 3; ++i)
        edges.append(triangles_(f, i), triangles_(f, (i + 1) % 3), around);
    return around;
}

/// Walks around what is left of a triangle, whose edges run against those of what is covered.
bool FacetOverlay::add_remainders(Index f, const std::vector<std::vector<Index>>& covered,
                                  const DividedEdges& edges,
                                  std::vector<std::vector<Index>>& remainders) const {
    std::map<std::pair<Index, Index>, int> counts;
    const auto add = [&](const std::vector<Index>& loop, int direction) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Index a = loop[i], b = loop[(i + 1) % loop.size()];
            counts[std::minmax(a, b)] += a < b ? direction : -direction;
        }
    };
    add(outline(f, edges), 1);
    for (const auto& loop : covered)
        add(loop, -1);
    std::map<Index, Index> next;
    for (const auto& [edge, count] : counts) {
        if (count == 0)
            continue;
        const auto [from, to] = count > 0 ? edge : std::pair(edge.second, edge.first);
        if (std::abs(count) > 1 || !next.emplace(from, to).second)
            return false;
    }
    while (!next.empty()) {
        auto& loop = remainders.emplace_back();
        for (auto at = next.begin(); at != next.end(); at = next.find(loop.back())) {
            if (loop.empty())
                loop.push_back(at->first);
            loop.push_back(at->second);
            next.erase(at);
        }
        if (loop.front() != loop.back())
            return false;
        loop.pop_back();
        const Eigen::MatrixX2d at = in_plane(f, loop);
        double twice_area = 0;
        for (Index i = 0; i < at.rows(); ++i) {
            const Index j = (i + 1) % static_cast<Index>(at.rows());
            twice_area += at(i, 0) * at(j, 1) - at(i, 1) * at(j, 0);
        }
        if (!(twice_area > 0)) // around a hole
            return false;
    }
    return true;
}

/// Around the vertex inside that is farthest from the edges, if there is one.
void FacetOverlay::add_fan(Index f, const DividedEdges& edges,
                           std::vector<TrianglePart>& parts) const {
    const std::vector<Index> around = outline(f, edges);
    double farthest = 0;
    Index center = -1;
    for (const Index v : vertices_[f]) {
        if (std::find(around.begin(), around.end(), v) != around.end())
            continue;
        double least = std::numeric_limits<double>::infinity();
        for (Index i = 0; i < 3; ++i) {
            const Points edge =
                points_({triangles_(f, i), triangles_(f, (i + 1) % 3)}, Eigen::indexing::all);
            least = std::min(least, squared_distance(points_.row(v), edge));
        }
        if (least > farthest) {
            farthest = least;
            center = v;
        }
    }
    for (std::size_t i = 0; i < around.size() && center >= 0; ++i)
        parts.push_back({corners(f), {center, around[i], around[(i + 1) % around.size()]}});
}

std::vector<TrianglePart> FacetOverlay::parts(const DividedEdges& edges) const {
    PolygonMesh all{points_, {}};
    std::vector<std::vector<Index>> owners; // triangles that each is a part of
    const auto add = [&](const std::vector<Index>& polygon, std::vector<Index> of) {
        all.add(polygon);
        all.tags.push_back(static_cast<Index>(owners.size()));
        owners.push_back(std::move(of));
    };
    std::vector<std::vector<std::vector<Index>>> covered(vertices_.size());
    for (const Common& common : commons_) {
        std::vector<Index> polygon;
        add_vertices(common, edges, polygon);
        add(polygon, {common.f, common.g});
        covered[common.f].push_back(polygon);
        if (is_turned(common.f, common.g))
            std::reverse(polygon.begin(), polygon.end());
        covered[common.g].push_back(std::move(polygon));
    }
    std::vector<TrianglePart> result;
    std::vector<bool> is_whole(covered.size(), false);
    for (Index f = 0; f < std::ssize(covered); ++f) {
        std::vector<std::vector<Index>> remainders;
        if (covered[f].empty())
            continue;
        if (!add_remainders(f, covered[f], edges, remainders)) {
            add_fan(f, edges, result);
            continue;
        }
        is_whole[f] = true;
        for (const auto& remainder : remainders)
            add(remainder, {f});
    }
    const Mesh split = split_polygons(std::move(all));
    for (Index t = 0; t < split.simplices.rows(); ++t)
        for (const Index f : owners[split.tags[t]])
            if (is_whole[f])
                result.push_back(
                    {corners(f),
                     {split.simplices(t, 0), split.simplices(t, 1), split.simplices(t, 2)}});
    return result;
}

} // namespace polydec
