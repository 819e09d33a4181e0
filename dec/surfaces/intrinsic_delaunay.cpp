// SPDX-License-Identifier: MIT
#include "dec/surfaces/intrinsic_delaunay.h"

#include "base/errors.h"
#include "dec/metric/side_lengths.h"
#include "dec/metric/triangle.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <queue>
#include <utility>

namespace polydec {

namespace {

/// Least relative amount by which two sides of a triangle must exceed its longest side: below it,
/// rounding of lengths leaves hardly a digit of the area. The height is then 3e-7 of the length.
constexpr double least_slack = 1e-13;

/// If points coincide (an edge is below the first fraction of the mean length), edges are
/// lengthened to the second. With less, stars there would be so large that all other stars would be
/// at the level of their rounding.
constexpr double coinciding = 1e-10, apart = 1e-5;

/// Lengths from points that may coincide or lie on a line: not negative, and no side longer than
/// both others together beyond rounding.
void check_roughly(const GluedSurface& surface, const Vector& lengths) {
    constexpr double rounding = 1e-9;
    const auto is_triangle = [&](Index t) {
        auto sides = side_lengths(surface, lengths, t);
        std::sort(sides.begin(), sides.end());
        return sides[0] >= 0 && sides[0] + sides[1] - sides[2] >= -rounding * sides[2];
    };
    bool rough = true;
    for (Index t = 0; rough && t < surface.triangles(); ++t)
        rough = is_triangle(t);
    if (!rough)
        check_lengths(surface, lengths); // reports the defect
}

/// An end of a half-edge.
enum class FanEnd { tail, head };

/// Visits the corners of the triangles around a vertex in order, from a boundary half-edge that
/// ends there to the next one. A corner is given by the half-edge that starts at it. Gluings may
/// reverse the orientation along the way.
template <class Visit>
void for_each_corner(const GluedSurface& surface, Index boundary_halfedge, FanEnd end,
                     Visit visit) {
    Index entered = boundary_halfedge;
    bool at_tail = end == FanEnd::tail;
    while (entered >= 0) {
        const Index corner = at_tail ? entered : GluedSurface::next(entered);
        visit(corner);
        const Index exit = at_tail ? GluedSurface::previous(entered) : GluedSurface::next(entered);
        const bool tail_of_exit = exit == corner;
        entered = surface.partner(exit);
        if (entered >= 0)
            at_tail = surface.sign(entered) == surface.sign(exit) ? tail_of_exit : !tail_of_exit;
    }
}

class Flipping {
public:
    Flipping(GluedSurface surface, Vector lengths, const IntrinsicDelaunayOptions& options)
        : surface_(std::move(surface)),
          lengths_(lengths.begin(), lengths.end()),
          history_(surface_),
          crossings_(surface_),
          options_(options) {
        for (const double l : lengths_)
            mean_length_ += l / static_cast<double>(lengths_.size());
        triangles_.resize(static_cast<std::size_t>(surface_.triangles()));
        if (const double missing = measure_all(); missing > 0)
            give_needles_some_area(missing);
    }

    IntrinsicDelaunay run() && {
        for (Index e = 0; e < surface_.edges(); ++e) {
            if (surface_.is_boundary(e)) {
                ++boundary_edges_;
                statistics_.negative_boundary_before += is_negative(e) ? 1 : 0;
            } else if (const double mean = negative_mean(e); mean < 0 && surface_.can_flip(e)) {
                first_.emplace_back(mean, e);
            }
        }
        std::sort(first_.begin(), first_.end());
        statistics_.negative_before = static_cast<Index>(first_.size());
        if (options_.boundary == BoundaryEdges::split)
            refuse_sharp_corners();
        flip_all();
        while (options_.boundary == BoundaryEdges::split && split_boundary())
            flip_all();
        count_what_is_left();
        return {std::move(surface_), as_vector(), std::move(history_), std::move(crossings_),
                statistics_};
    }

private:
    struct alignas(32) Measured {
        double area;
        std::array<double, 3> cotangents; // of the corners opposite to its half-edges
    };

    /// The triangle beside a half-edge: lengths of this, the next and the last side; area.
    struct Beside {
        double a, b, c, area;
        double cotangent() const { return corner_cotangent(a, b, c, area); }
        /// Foot of the apex: position along the half-edge from its tail.
        double foot() const { return (a + (c - b) * ((c + b) / a)) / 2; }
        double height() const { return 2 * area / a; }
    };
    Beside beside(Index halfedge) const {
        return {length(halfedge), length(GluedSurface::next(halfedge)),
                length(GluedSurface::previous(halfedge)),
                triangles_[GluedSurface::triangle(halfedge)].area};
    }
    Vector as_vector() const {
        return Eigen::Map<const Vector>(lengths_.data(),
                                        static_cast<Eigen::Index>(lengths_.size()));
    }
    double length(Index halfedge) const { return lengths_[surface_.edge(halfedge)]; }

    double cotangent(Index halfedge) const {
        return triangles_[GluedSurface::triangle(halfedge)].cotangents[halfedge % 3];
    }

    /// Rounding error of the cotangents of two such triangles: from lengths, whose squares cancel,
    /// and from the shape. (R/a)^2 = (1 + cot^2) / 4, and the sum is (a^2 + b^2 + c^2) / 4A.
    double rounding(Index halfedge) const {
        constexpr double few = 64 * std::numeric_limits<double>::epsilon();
        const auto& [x, y, z] = triangles_[GluedSurface::triangle(halfedge)].cotangents;
        const double own = cotangent(halfedge);
        return few * std::max((1 + own * own) / 4, x + y + z);
    }

    void set_area(Index triangle, double area) {
        triangles_[triangle].area = area;
        for (Index i = 0; i < 3; ++i)
            triangles_[triangle].cotangents[i] = beside(3 * triangle + i).cotangent();
    }

    /// Computes all areas; returns by how much sides must exceed so that every triangle has area.
    double measure_all() {
        double missing = 0;
        for (const double l : lengths_)
            if (l <= coinciding * mean_length_)
                missing = std::max(missing, apart * mean_length_ - l);
        for (Index t = 0; t < surface_.triangles(); ++t) {
            const double a = length(3 * t), b = length(3 * t + 1), c = length(3 * t + 2);
            const double longest = std::max({a, b, c});
            missing = std::max(missing, least_slack * longest - (a + b + c - 2 * longest));
            set_area(t, triangle_area(a, b, c));
        }
        return missing;
    }

    /// Flips of triangles without area would produce lengths of pure rounding error. Lengthening
    /// all edges equally preserves every gluing.
    void give_needles_some_area(double missing) {
        check_roughly(surface_, as_vector());
        const auto area = [&] {
            return std::accumulate(triangles_.begin(), triangles_.end(), 0.0,
                                   [](double sum, const Measured& t) { return sum + t.area; });
        };
        const double before = area();
        statistics_.added_length = missing;
        for (double& l : lengths_)
            l += missing;
        mean_length_ += missing;
        measure_all();
        check_lengths(surface_, as_vector());
        statistics_.added_area = before > 0 ? area() / before - 1 : 0;
    }

    /// Mean of the cotangents on both sides; 0 unless negative beyond rounding.
    double negative_mean(Index edge) const {
        const auto& [h, g] = surface_.halfedges(edge);
        const double mean = (cotangent(h) + (g < 0 ? 0 : cotangent(g))) / 2;
        if (!(mean < 0))
            return 0;
        return mean < -std::max(rounding(h), g < 0 ? 0 : rounding(g)) ? mean : 0;
    }

    bool is_negative(Index edge) const { return negative_mean(edge) < 0; }

    void count_what_is_left() {
        for (const Index e : stuck_)
            statistics_.negative_interior += is_negative(e) ? 1 : 0;
        for (Index e = 0; e < surface_.edges(); ++e)
            statistics_.negative_boundary += surface_.is_boundary(e) && is_negative(e) ? 1 : 0;
    }

    void look_at(Index edge) {
        if (const double mean = negative_mean(edge); mean < 0 && surface_.can_flip(edge))
            later_.emplace(mean, edge);
    }

    /// The most negative edge, of those found first or later.
    std::pair<double, Index> pop() {
        if (next_ < first_.size() && (later_.empty() || first_[next_] < later_.top()))
            return first_[next_++];
        const auto top = later_.top();
        later_.pop();
        return top;
    }

    void flip_all() {
        const std::int64_t limit = 1000 + std::int64_t{options_.most} * surface_.edges();
        while (next_ < first_.size() || !later_.empty()) {
            const auto [mean, edge] = pop();
            if (!surface_.can_flip(edge) || negative_mean(edge) != mean)
                continue; // reinserted when an adjacent triangle changed
            flip(edge);
            if (statistics_.flips > limit)
                throw SolverFailure(
                    fmt::format("{} flips of {} edges did not suffice: the surface has triangles "
                                "of almost no area; remesh or tidy it",
                                statistics_.flips, surface_.edges()));
        }
    }

    void flip(Index edge) {
        if (!surface_.is_coherent(edge)) {
            const Index turned = GluedSurface::triangle(surface_.halfedges(edge)[1]);
            surface_.reverse(turned);
            set_area(turned, triangles_[turned].area);
            history_.reverse(turned);
        }
        // both triangles laid flat: i at the origin, j on the first axis, k above and l below
        const auto [h, g] = surface_.halfedges(edge);
        const auto above = beside(h), below = beside(g);
        const double along = above.foot() - (below.a - below.foot());
        const double diagonal = std::hypot(along, above.height() + below.height());
        const double klj = triangle_area(diagonal, below.c, above.b);
        const double lki = triangle_area(diagonal, above.c, below.b);
        if (!(klj > 0 && lki > 0))
            return stuck_.push_back(edge); // the corner at i or j is flat up to rounding

        history_.flip(surface_, edge, above.area / (above.area + below.area), klj / (klj + lki));
        crossings_.flip(surface_, edge);
        surface_.flip(edge);
        lengths_[edge] = diagonal;
        set_area(GluedSurface::triangle(h), klj);
        set_area(GluedSurface::triangle(g), lki);
        ++statistics_.flips;
        for (const Index side : surface_.halfedges(edge)) {
            look_at(surface_.edge(GluedSurface::next(side)));
            look_at(surface_.edge(GluedSurface::previous(side)));
        }
    }

    /// Splits all boundary edges that need it at once, so their order does not matter: two edges of
    /// one triangle both need it only beside a sharp corner.
    bool split_boundary() {
        const double goal = split_goal();
        std::vector<std::pair<Index, double>> places;
        for (Index e = 0; e < surface_.edges(); ++e)
            if (surface_.is_boundary(e) && cotangent(surface_.halfedges(e)[0]) / 2 <= goal)
                places.emplace_back(e, place_of_split(e));
        for (const auto& [edge, fraction] : places)
            split(edge, fraction);
        const std::int64_t limit = 10000 + std::int64_t{options_.most} * boundary_edges_;
        if (statistics_.splits > limit)
            throw SolverFailure(
                fmt::format("{} splits of {} boundary edges did not suffice: the boundary has "
                            "corners of almost no angle; use flips without splits",
                            statistics_.splits, boundary_edges_));
        return !places.empty();
    }

    void split(Index edge, double fraction) {
        const Index h = surface_.halfedges(edge)[0];
        const auto whole = beside(h);
        history_.split_boundary(surface_, edge, fraction);
        crossings_.split_boundary(surface_, edge);
        surface_.split_boundary(edge);
        lengths_[edge] = fraction * whole.a;
        lengths_.push_back((1 - fraction) * whole.a);
        lengths_.push_back(std::hypot(whole.foot() - fraction * whole.a, whole.height()));
        triangles_.emplace_back();
        set_area(surface_.triangles() - 1, (1 - fraction) * whole.area);
        set_area(GluedSurface::triangle(h), fraction * whole.area);
        ++statistics_.splits;
        for (const Index t : {GluedSurface::triangle(h), surface_.triangles() - 1})
            for (Index i = 0; i < 3; ++i)
                look_at(surface_.edge(3 * t + i));
    }

    /// Position of the split of a boundary edge, as a fraction from its half-edge's tail. Splits on
    /// both sides of a sharp corner would trigger each other forever unless at equal distances from
    /// it.
    double place_of_split(Index edge) const {
        const Index h = surface_.halfedges(edge)[0];
        const bool tail = has_acute_corner(h, FanEnd::tail),
                   head = has_acute_corner(h, FanEnd::head);
        if (tail == head)
            return 0.5;
        const double l = lengths_[edge];
        const double exponent = std::round(std::log2(l / 2 / mean_length_));
        const double part = mean_length_ * std::exp2(exponent) / l;
        return tail ? part : 1 - part;
    }

    /// The interior angle at one end of a boundary half-edge.
    double boundary_corner(Index halfedge, FanEnd end) const {
        double angle = 0;
        for_each_corner(surface_, halfedge, end, [&](Index corner) {
            const auto opposite = beside(GluedSurface::next(corner));
            angle += corner_angle(opposite.a, opposite.b, opposite.c, opposite.area);
        });
        return angle;
    }

    /// Whether the boundary turns by a right angle or more there.
    bool has_acute_corner(Index halfedge, FanEnd end) const {
        constexpr double rounding = 1e-9;
        return boundary_corner(halfedge, end) <= std::numbers::pi / 2 + rounding;
    }

    /// Splits make boundary stars positive, but not arbitrarily large: halves of a triangle can be
    /// similar to the whole.
    double split_goal() const {
        constexpr double most_a_split_can_promise = 1e-2;
        return std::min(options_.tolerance, most_a_split_can_promise);
    }

    /// In every Delaunay triangulation the angles opposite the two edges at a corner of angle t sum
    /// to at least pi - t, so one of these edges has a star of at most tan(t/2) / 2.
    void refuse_sharp_corners() const {
        for (Index e = 0; e < surface_.edges(); ++e) {
            if (!surface_.is_boundary(e))
                continue;
            const Index h = surface_.halfedges(e)[0];
            for (const FanEnd end : {FanEnd::tail, FanEnd::head}) {
                const double angle = boundary_corner(h, end);
                const Index vertex = surface_.vertex_number(end == FanEnd::tail ? surface_.tail(h)
                                                                                : surface_.head(h));
                if (std::tan(std::min(angle, std::numbers::pi / 2) / 2) / 2 <= split_goal())
                    throw InvalidInput(
                        fmt::format("the boundary has a corner of angle {:.2g} at vertex {}: "
                                    "however its edges are split, one keeps a dual below {:.2g} of "
                                    "its length; use flips without splits",
                                    angle, vertex, split_goal()),
                        {.vertices = {vertex}});
            }
        }
    }

    GluedSurface surface_;
    std::vector<double> lengths_;
    std::vector<Measured> triangles_;
    FlipHistory history_;
    NormalCoordinates crossings_;
    IntrinsicDelaunayOptions options_;
    IntrinsicStatistics statistics_;
    /// Edges to flip with their means when found, by which they are ordered, so numbering does not
    /// matter: the negative edges of the input, of which next_ are done, and later ones.
    using Found = std::pair<double, Index>;
    std::vector<Found> first_;
    std::size_t next_ = 0;
    std::priority_queue<Found, std::vector<Found>, std::greater<>> later_;
    std::vector<Index> stuck_;
    double mean_length_ = 0;
    Index boundary_edges_ = 0;
};

} // namespace

IntrinsicDelaunay intrinsic_delaunay(GluedSurface surface, Vector lengths,
                                     const IntrinsicDelaunayOptions& options) {
    if (lengths.size() != surface.edges() || !lengths.allFinite())
        check_lengths(surface, lengths); // reports the defect
    // keeps products of lengths finite at every scale; a power of two changes no digit
    constexpr int moderate = 40;
    const double longest = lengths.size() > 0 ? lengths.cwiseAbs().maxCoeff() : 0;
    const bool is_extreme = longest > 0 && std::abs(std::ilogb(longest)) > moderate;
    const double unit = is_extreme ? std::exp2(std::ilogb(longest)) : 1;
    auto result = Flipping(std::move(surface), lengths / unit, options).run();
    result.lengths *= unit;
    result.statistics.added_length *= unit;
    return result;
}

} // namespace polydec
