// SPDX-License-Identifier: MIT
#include "base/checks.h"
#include "base/errors.h"
#include "shape/geodesics.h"
#include "shape/sources.h"
#include "shape/windows.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace polydec {

namespace {

/// A point in the plane of a triangle, whose side runs along the first axis from its tail at 0.
using Place = Eigen::Vector2d;

/// Where the straight line from a point to the place of a window crosses its side, or the nearest
/// that is seen: where rounding has opened gaps, ways bend at the end of what is.
double crossing(const Fan& fan, const Place& point) {
    const double height = point[1] + fan.below;
    const double share = height > 0 ? fan.below / height : 0;
    return std::clamp(fan.along + (point[0] - fan.along) * share, fan.begin, fan.end);
}

double length_through(const Fan& fan, const Place& point) {
    const double x = crossing(fan, point);
    return fan.offset + std::hypot(x - fan.along, fan.below) + std::hypot(point[0] - x, point[1]);
}

} // namespace

Vector exact_distance(const Triangles& surface, const Vector& lengths,
                      std::span<const Index> sources, const Progress& progress) {
    const UnfoldedTriangles unfolded(surface, lengths);
    check_sources(surface, sources);
    const auto found =
        distances_by_windows(unfolded, sources, most_windows(surface.triangles()), progress);
    return in_units_of_lengths(surface, found.distances, unfolded.exponent());
}

struct ShortestPaths::Parts {
    UnfoldedTriangles surface;
    WindowTrace trace;
    Vector distances, unfolded; ///< in units of lengths, and of the unfolded triangles
    Groups windows;             ///< by half-edges

    /// The corner opposite to a side, in the plane of the side.
    Place apex(Index h) const {
        const double length = surface.side(Triangles::previous(h)).length;
        return length * Place(surface.side(h).cosine, surface.side(h).sine);
    }

    /// The point of a side of the triangle in the plane of the side `base`.
    Place in_plane(const SidePoint& point, Index base) const {
        const Place head(surface.side(base).length, 0);
        if (point.halfedge == base)
            return point.fraction * head;
        return point.halfedge == Triangles::next(base)
                   ? Place(head + point.fraction * (apex(base) - head))
                   : Place((1 - point.fraction) * apex(base));
    }

    double length(const PathPiece& piece) const {
        return (in_plane(piece.begin, piece.begin.halfedge) -
                in_plane(piece.end, piece.begin.halfedge))
            .norm();
    }

    /// Adds what leads from a corner straight back to the corner where the last line starts, whose
    /// half-edge it returns.
    Index trace_line(const WindowArrival& arrival, std::vector<PathPiece>& pieces) const {
        SidePoint at{arrival.corner, 0};
        Index before = arrival.before;
        while (before >= 0) {
            const PassedWindow& window = trace.windows[before];
            const double x = crossing(window.fan, in_plane(at, window.side));
            const SidePoint on{window.side, x / surface.side(window.side).length};
            pieces.push_back({at, on});
            before = window.before;
            at = across(on, before >= 0 ? Triangles::triangle(trace.windows[before].side)
                                        : Triangles::triangle(-1 - before));
        }
        pieces.push_back({at, {-1 - before, 0}});
        return -1 - before;
    }

    /// The same point as the other triangle at the side has it.
    SidePoint across(const SidePoint& on, Index triangle) const {
        const auto& side = surface.side(on.halfedge);
        for (const Index h : surface.sides_of(side.edge))
            if (Triangles::triangle(h) == triangle && h != on.halfedge)
                return {h, surface.side(h).sign == side.sign ? on.fraction : 1 - on.fraction};
        return on; // not reached: windows pass from triangle to triangle by their sides
    }
};

ShortestPaths::ShortestPaths(const Triangles& surface, const Vector& lengths,
                             std::span<const Index> sources, const Progress& progress)
    : parts_(std::make_shared<Parts>(Parts{{surface, lengths}, {}, {}, {}, {}})) {
    Parts& parts = *parts_;
    check_sources(surface, sources);
    parts.unfolded = distances_by_windows(parts.surface, sources, most_windows(surface.triangles()),
                                          progress, &parts.trace)
                         .distances;
    parts.distances = in_units_of_lengths(surface, parts.unfolded, parts.surface.exponent());
    const auto& windows = parts.trace.windows;
    parts.windows = Groups(static_cast<Index>(windows.size()), 3 * surface.triangles(),
                           [&](Index w) { return windows[w].side; });
}

const Vector& ShortestPaths::distances() const& {
    return parts_->distances;
}

double ShortestPaths::at(Index triangle, const Eigen::Vector3d& coordinates) const {
    const Parts& parts = *parts_;
    check_number("the distance of a point of triangle", triangle, 0, parts.surface.triangles() - 1);
    constexpr double rounding = 1e-9;
    if (!(coordinates.minCoeff() >= -rounding && std::abs(coordinates.sum() - 1) <= rounding))
        throw InvalidInput(fmt::format("the distance of a point of triangle {} at the barycentric "
                                       "coordinates {}: expected numbers >= 0 whose sum is 1",
                                       triangle, fmt::join(coordinates, ", ")));
    double nearest = std::numeric_limits<double>::infinity();
    for (Index i = 0; i < 3; ++i) {
        const Index h = 3 * triangle + i;
        const Place point = coordinates[(i + 1) % 3] * Place(parts.surface.side(h).length, 0) +
                            coordinates[(i + 2) % 3] * parts.apex(h);
        nearest = std::min(nearest, parts.unfolded[parts.surface.side(h).tail] + point.norm());
        for (const Index w : parts.windows[h])
            nearest = std::min(nearest, length_through(parts.trace.windows[w].fan, point));
    }
    return std::ldexp(nearest, parts.surface.exponent());
}

ShortestPath ShortestPaths::from(Index vertex) const {
    const Parts& parts = *parts_;
    check_number("the path from vertex", vertex, 0, parts.surface.vertices() - 1);
    ShortestPath path{vertex, 0, {}};
    while (parts.trace.arrivals[path.source].corner >= 0) {
        const Index start = parts.trace_line(parts.trace.arrivals[path.source], path.pieces);
        path.source = parts.surface.side(start).tail;
    }
    double length = 0;
    for (const PathPiece& piece : path.pieces)
        length += parts.length(piece);
    path.length = std::ldexp(length, parts.surface.exponent());
    return path;
}

} // namespace polydec
