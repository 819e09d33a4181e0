// SPDX-License-Identifier: MIT
#include "base/checks.h"
#include "base/errors.h"
#include "base/lists.h"
#include "dec/metric/simplex_metric.h"
#include "dec/surfaces/intrinsic_delaunay.h"
#include "dec/surfaces/passage.h"
#include "dec/surfaces/strand_places.h"

#include <algorithm>
#include <cmath>

namespace polydec {

namespace {

/// A point on the side of a triangle along this half-edge.
struct SidePoint {
    Index point;
    Index halfedge;
    double place; ///< from 0 at its tail to 1
};

using Polygon = std::vector<SidePoint>;

/// Cuts the flipped triangles along the edges of the input.
class Cutter {
public:
    Cutter(const Passage& passage, const IntrinsicDelaunay& flips, const Points& points)
        : K_(passage.input()),
          pieces_(passage.pieces()),
          points_(points),
          lengths_(flips.lengths),
          surface_(flips.surface),
          coordinates_(flips.crossings),
          new_vertices_(flips.history.edges_of_new_vertices()) {
        first_crossing_.push_back(static_cast<Index>(points.rows()));
        for (Index e = 0; e < surface_.edges(); ++e)
            first_crossing_.push_back(first_crossing_.back() + coordinates_.crossings(e));
    }

    Overlay cut() {
        place_points();
        for (Index t = 0; t < surface_.triangles(); ++t)
            cut_triangle(t);
        result_.areas =
            Eigen::Map<const Vector>(areas_.data(), static_cast<Eigen::Index>(areas_.size()));
        return std::move(result_);
    }

private:
    void place_points() {
        result_.offsets.push_back(0);
        result_.crossings.resize(first_crossing_.back() - first_crossing_[0]);
        ends_by_point_.assign(static_cast<std::size_t>(first_crossing_.back()), {-1, -1});
        for (Index v = 0; v < surface_.vertices(); ++v) {
            ends_by_point_[v] = {v, v};
            if (v >= K_.size(0))
                ends_by_point_[v] = new_vertices_[v - K_.size(0)];
        }

        places_.resize(result_.crossings.size());
        const Strands strands = trace(surface_, coordinates_);
        const auto places = strand_places(surface_, lengths_, strands);
        for (std::size_t s = 0; s < strands.ends.size(); ++s) {
            const Index a = surface_.tail(strands.ends[s][0]),
                        b = surface_.tail(strands.ends[s][1]);
            for (std::size_t c = strands.offsets[s]; c < strands.offsets[s + 1]; ++c) {
                const Index point =
                    point_on(strands.crossings[c].halfedge, strands.crossings[c].position).point;
                result_.crossings[point - first_crossing_[0]] = {a, b, places[c]};
                ends_by_point_[point] = {a, b};
            }
        }
        result_.points.resize(points_.rows() + Eigen::Index(result_.crossings.size()),
                              points_.cols());
        result_.points = result_.at_points(points_);
        place_along_edges();
    }

    /// Between crossings an edge is straight in space.
    void place_along_edges() {
        for (Index e = 0; e < surface_.edges(); ++e) {
            Index last = surface_.first_vertex(e);
            double length = 0;
            const auto go_on_to = [&](Index point) {
                length += (result_.points.row(point) - result_.points.row(last)).norm();
                last = point;
            };
            for (Index point = first_crossing_[e]; point < first_crossing_[e + 1]; ++point) {
                go_on_to(point);
                places_[point - first_crossing_[0]] = length;
            }
            go_on_to(surface_.last_vertex(e));
            for (Index point = first_crossing_[e]; point < first_crossing_[e + 1]; ++point)
                places_[point - first_crossing_[0]] /= length > 0 ? length : 1;
        }
    }

    void cut_triangle(Index t) {
        const auto corners = coordinates_.corners(surface_, t);
        for (Index i = 0; i < 3; ++i)
            cut_corner(3 * t + i, corners.cut[i]);
        cut_middle(t, corners);
    }

    /// The pieces that strands cut off around a corner: a triangle, and quadrilaterals behind it.
    void cut_corner(Index corner, Index cuts) {
        for (Index r = 0; r < cuts; ++r) {
            Polygon piece{point_at(corner)};
            if (r > 0)
                piece = {point_before(corner, r - 1), point_on(corner, r - 1)};
            piece.push_back(point_on(corner, r));
            piece.push_back(point_before(corner, r));
            add(piece, GluedSurface::triangle(corner));
        }
    }

    /// The remaining middle, with a fan of strands that begin at one of the corners.
    void cut_middle(Index t, const NormalCoordinates::Corners& corners) {
        const auto rest_of_corner = [&](Index i) {
            const Index corner = 3 * t + i, cuts = corners.cut[i];
            return cuts == 0 ? Polygon{point_at(corner)}
                             : Polygon{point_before(corner, cuts - 1), point_on(corner, cuts - 1)};
        };
        const auto append = [](Polygon& polygon, const Polygon& more) {
            polygon.insert(polygon.end(), more.begin(), more.end());
        };
        Index i = 0;
        while (i < 2 && corners.leaving[i] == 0)
            ++i;
        const Index j = (i + 1) % 3, k = (i + 2) % 3;
        const Polygon from = rest_of_corner(i);
        Polygon piece = from;
        append(piece, rest_of_corner(j));
        for (Index strand = 0; strand < corners.leaving[i]; ++strand) {
            const SidePoint point = point_on(3 * t + j, corners.cut[j] + strand);
            piece.push_back(point);
            add(piece, t);
            piece = from;
            piece.push_back(point);
        }
        append(piece, rest_of_corner(k));
        add(piece, t);
    }

    void add(const Polygon& polygon, Index t) {
        const Index triangle = input_triangle(polygon);
        if (triangle < 0)
            return;
        // the plane of the triangle that contains it, oriented alike
        const auto corner = [&](int i) {
            return result_.points.row(K_.simplices(2)(triangle, i)).eval();
        };
        const auto e = (corner(1) - corner(0)).eval(), f = (corner(2) - corner(0)).eval();
        double area = 0, turn = 0, longest = 0;
        const auto origin = result_.points.row(polygon[0].point);
        for (std::size_t i = 2; i < polygon.size(); ++i) {
            const auto u = (result_.points.row(polygon[i - 1].point) - origin).eval();
            const auto v = (result_.points.row(polygon[i].point) - origin).eval();
            const double squared = u.squaredNorm() * v.squaredNorm() - std::pow(u.dot(v), 2);
            area += std::sqrt(std::max(0.0, squared)) / 2;
            longest = std::max({longest, u.squaredNorm(), v.squaredNorm()});
            turn += u.dot(e) * v.dot(f) - u.dot(f) * v.dot(e);
        }
        constexpr double rounding = 1e-12;
        if (!(area > rounding * longest))
            return;
        result_.signs.push_back(turn * K_.orientation(triangle) < 0 ? -1 : 1);
        const auto order = corners_in_order(t);
        for (const auto& [point, halfedge, place] : polygon) {
            result_.corners.push_back(point);
            auto& coordinates = result_.coordinates.emplace_back();
            coordinates[order[halfedge % 3]] = 1 - place;
            coordinates[order[GluedSurface::next(halfedge) % 3]] = place;
        }
        result_.offsets.push_back(static_cast<Index>(result_.corners.size()));
        result_.input.push_back(triangle);
        result_.triangle.push_back(t);
        areas_.push_back(area);
    }

    /// The triangle of the input whose vertices and edges contain the corners of a piece; -1 if
    /// these are all on one edge.
    Index input_triangle(const Polygon& polygon) const {
        std::vector<Index> vertices;
        for (const SidePoint& corner : polygon)
            for (const Index v : ends_by_point_[corner.point])
                vertices.push_back(v);
        sort_unique(vertices);
        return K_.find(2, K_.vertex_numbers(vertices));
    }

    /// For each corner of a triangle its corner in the ordered piece: opposite the same edge, with
    /// the same orientation.
    std::array<int, 3> corners_in_order(Index t) const {
        const int step = pieces_.orientation(t) > 0 ? 1 : 2;
        std::array<int, 3> order{};
        const auto fits = [&](int first) {
            for (int i = 0; i < 3; ++i)
                order[i] = (first + step * i) % 3;
            for (int i = 0; i < 3; ++i)
                if (pieces_.face(2, t, order[i]) != surface_.edge(3 * t + (i + 1) % 3))
                    return false;
            return true;
        };
        int first = 0;
        while (!fits(first) && first < 2)
            ++first;
        return order;
    }

    SidePoint point_at(Index corner) const { return {surface_.tail(corner), corner, 0}; }

    /// The crossing with this number on a half-edge, counted from its tail.
    SidePoint point_on(Index halfedge, Index position) const {
        const Index e = surface_.edge(halfedge);
        const bool along = surface_.sign(halfedge) > 0;
        const Index last = coordinates_.crossings(e) - 1;
        const Index point = first_crossing_[e] + (along ? position : last - position);
        const double place = places_[point - first_crossing_[0]];
        return {point, halfedge, along ? place : 1 - place};
    }
    /// The same on the half-edge that ends at a corner, counted from the corner.
    SidePoint point_before(Index corner, Index position) const {
        const Index h = GluedSurface::previous(corner);
        return point_on(h, coordinates_.crossings(surface_.edge(h)) - 1 - position);
    }

    const SimplicialComplex& K_;
    const Pieces& pieces_;
    const Points& points_;
    const Vector& lengths_;
    const GluedSurface& surface_;
    const NormalCoordinates& coordinates_;
    std::vector<std::array<Index, 2>> new_vertices_;
    std::vector<Index> first_crossing_;               // points on each edge
    std::vector<double> places_;                      // of crossings along these edges
    std::vector<std::array<Index, 2>> ends_by_point_; // ends of the input's edge that contains it
    std::vector<double> areas_;
    Overlay result_;
};

} // namespace

Points Overlay::at_points(const Points& at_vertices) const {
    const auto vertices = at_vertices.rows(), more = static_cast<Eigen::Index>(crossings.size());
    check_as_many("rows of vertices", vertices, points.rows() - more);
    Points result(vertices + more, at_vertices.cols());
    result.topRows(vertices) = at_vertices;
    for (Eigen::Index c = 0; c < more; ++c) {
        const auto& [from, to, place] = crossings[c];
        result.row(vertices + c) =
            (1 - place) * at_vertices.row(from) + place * at_vertices.row(to);
    }
    return result;
}

Overlay overlay(const Passage& passage, const Points& points) {
    const auto& flips = passage.flips("an overlay of the input's triangles and those after flips");
    if (passage.is_identity())
        throw InvalidInput("an overlay needs triangles after flips, but no edge was flipped");
    require_points(passage.pieces(), points, "an overlay");
    return Cutter(passage, flips, points).cut();
}

} // namespace polydec
