// SPDX-License-Identifier: MIT
#include "backends/mesher/closed_surfaces.h"

#include "backends/mesher/polygon_sides.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace polydec {

namespace {

using Place = Eigen::Vector3d;

/// Across each edge the neighbor, and whether both turn alike.
struct Neighbors {
    std::vector<Index> begin;
    std::vector<std::pair<Index, bool>> list;
};

Neighbors neighbors(const std::vector<PolygonSide>& sides, std::span<const Index> offsets) {
    Neighbors result;
    result.begin.assign(offsets.begin(), offsets.end());
    result.list.resize(sides.size());
    std::vector<Index> next(offsets.begin(), offsets.end());
    for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {
        const bool alike = sides[i].ascends != sides[i + 1].ascends;
        for (const auto& [from, to] : {std::pair{i, i + 1}, {i + 1, i}}) {
            const auto polygon = static_cast<std::size_t>(sides[from].polygon);
            result.list[static_cast<std::size_t>(next[polygon]++)] = {sides[to].polygon, alike};
        }
    }
    return result;
}

/// Gives the part of a polygon, and all that can be reached from it, a number and a way to turn.
void gather(const Neighbors& around, Index seed, Index part, ClosedSurfaces& result) {
    std::vector<Index> open{seed};
    result.part[static_cast<std::size_t>(seed)] = part;
    while (!open.empty()) {
        const auto here = static_cast<std::size_t>(open.back());
        open.pop_back();
        for (Index i = around.begin[here]; i < around.begin[here + 1]; ++i) {
            const auto [other, alike] = around.list[static_cast<std::size_t>(i)];
            const auto there = static_cast<std::size_t>(other);
            const bool turns = result.outward[here] == alike;
            if (result.part[there] < 0) {
                result.part[there] = part;
                result.outward[there] = turns;
                open.push_back(other);
            } else if (result.outward[there] != turns) {
                result.twisted = other;
            }
        }
    }
}

/// The volumes of the pyramids over the polygons, from one corner of each part.
void measure(const Points& points, std::span<const Index> corners, std::span<const Index> offsets,
             ClosedSurfaces& result) {
    std::vector<Index> apex(result.volumes.size(), -1);
    for (std::size_t f = 0; f < result.part.size(); ++f) {
        const auto part = static_cast<std::size_t>(result.part[f]);
        const auto first = static_cast<std::size_t>(offsets[f]);
        if (apex[part] < 0)
            apex[part] = corners[first];
        const Place origin = points.row(apex[part]);
        const Place base = points.row(corners[first]).transpose() - origin;
        Place area = Place::Zero();
        double size = base.norm();
        for (auto i = first + 1; i + 1 < static_cast<std::size_t>(offsets[f + 1]); ++i) {
            const Place a = points.row(corners[i]).transpose() - origin;
            const Place b = points.row(corners[i + 1]).transpose() - origin;
            area += (a - base).cross(b - base) / 2.0;
            size = std::max({size, a.norm(), b.norm()});
        }
        result.volumes[part] += (result.outward[f] ? 1.0 : -1.0) * area.dot(base) / 3.0;
        result.reach += area.norm() * size;
    }
}

} // namespace

ClosedSurfaces closed_surfaces(const Points& points, std::span<const Index> corners,
                               std::span<const Index> offsets) {
    ClosedSurfaces result;
    const auto count = offsets.empty() ? 0 : offsets.size() - 1;
    result.part.assign(count, -1);
    result.outward.assign(count, true);
    const auto sides = sorted_sides(corners, offsets);
    for (std::size_t i = 0; i < sides.size(); i += 2) {
        const bool paired = i + 1 < sides.size() && sides[i].beside(sides[i + 1]) &&
                            (i + 2 == sides.size() || !sides[i + 2].beside(sides[i]));
        if (!paired) {
            result.odd_edge = sides[i].low;
            return result;
        }
    }
    const auto around = neighbors(sides, offsets);
    Index parts = 0;
    for (std::size_t f = 0; f < count; ++f)
        if (result.part[f] < 0)
            gather(around, static_cast<Index>(f), parts++, result);
    result.volumes.assign(static_cast<std::size_t>(parts), 0.0);
    measure(points, corners, offsets, result);

    // what was taken for outward at the first polygon of a part may be inward
    for (std::size_t f = 0; f < count; ++f)
        if (result.volumes[static_cast<std::size_t>(result.part[f])] < 0.0)
            result.outward[f] = !result.outward[f];
    for (double& volume : result.volumes)
        volume = std::abs(volume);
    return result;
}

std::vector<double> windings(const Points& points, std::span<const Index> corners,
                             std::span<const Index> offsets, const ClosedSurfaces& surfaces,
                             const Place& place) {
    // The solid angle of a triangle: van Oosterom and Strackee, IEEE Trans. Biomed. Eng. 30 (1983).
    constexpr double in_plane = 1e-12;
    const auto seen = [&](std::size_t corner) -> Place {
        return points.row(corners[corner]).transpose() - place;
    };
    std::vector<double> turns(surfaces.volumes.size(), 0.0);
    for (std::size_t f = 0; f < surfaces.part.size(); ++f) {
        const auto first = static_cast<std::size_t>(offsets[f]);
        const Place a = seen(first);
        double angle = 0.0;
        for (auto i = first + 1; i + 1 < static_cast<std::size_t>(offsets[f + 1]); ++i) {
            const Place b = seen(i), c = seen(i + 1);
            const double cosine = a.norm() * b.norm() * c.norm() + a.dot(b) * c.norm() +
                                  b.dot(c) * a.norm() + c.dot(a) * b.norm();
            const double volume = a.dot(b.cross(c));
            if (std::abs(volume) > in_plane * a.norm() * b.norm() * c.norm())
                angle += 2.0 * std::atan2(volume, cosine);
        }
        turns[static_cast<std::size_t>(surfaces.part[f])] +=
            (surfaces.outward[f] ? angle : -angle) / (4.0 * std::numbers::pi);
    }
    return turns;
}

} // namespace polydec
