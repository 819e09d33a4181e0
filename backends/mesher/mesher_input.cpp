// SPDX-License-Identifier: MIT
#include "backends/mesher/mesher_input.h"

#include "backends/mesher/closed_surfaces.h"
#include "backends/mesher/polygon_sides.h"
#include "base/errors.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

namespace polydec {

namespace {

using Place = Eigen::Vector3d;
using Facet = std::span<const Index>;

constexpr double flat_tolerance = 1e-12;   // volumes and areas, relative to lengths
constexpr double winding_tolerance = 1e-6; // of holes that are off the surface

Facet facet(const MesherInput& input, Index f) {
    const auto number = static_cast<std::size_t>(f);
    const auto begin = static_cast<std::size_t>(input.offsets[number]);
    const auto end = static_cast<std::size_t>(input.offsets[number + 1]);
    return Facet(input.corners).subspan(begin, end - begin);
}

void check_finite(const Points& points, const char* kind) {
    if (points.cols() != 3) {
        throw InvalidInput(fmt::format("mesher: a {} has {} coordinates; tetrahedra are made in "
                                       "three",
                                       kind, points.cols()));
    }
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        if (!points.row(i).allFinite()) {
            throw InvalidInput(fmt::format("mesher: {} {} is at ({}, {}, {}): coordinates must be "
                                           "finite",
                                           kind, i, points(i, 0), points(i, 1), points(i, 2)));
        }
    }
}

void check_offsets(const MesherInput& input) {
    const auto& offsets = input.offsets;
    const bool whole = offsets.empty() ? input.corners.empty()
                                       : offsets.front() == 0 &&
                                             std::cmp_equal(offsets.back(), input.corners.size());
    if (!whole || !std::is_sorted(offsets.begin(), offsets.end())) {
        throw InvalidInput(fmt::format("mesher: the offsets of the facets must ascend from 0 to "
                                       "the number of corners, {}",
                                       input.corners.size()));
    }
}

Error::Place place_of(const MesherInput& input, Index f) {
    const Facet corners = facet(input, f);
    return {.degree = 2, .cells = {f}, .vertices = {corners.begin(), corners.end()}};
}

void check_corners(const MesherInput& input, Index f) {
    const Facet corners = facet(input, f);
    if (corners.size() < 3) {
        throw InvalidInput(
            fmt::format("mesher: facet {} has {} corners; a facet needs three", f, corners.size()),
            place_of(input, f));
    }
    for (const Index corner : corners) {
        if (corner < 0 || corner >= input.points.rows()) {
            throw InvalidInput(fmt::format("mesher: facet {} has the corner {}, but the points are "
                                           "0 to {}",
                                           f, corner, input.points.rows() - 1),
                               place_of(input, f));
        }
    }
    std::vector<Index> sorted(corners.begin(), corners.end());
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end()) {
        throw InvalidInput(
            fmt::format("mesher: facet {} has the corner {} twice", facet_name(input, f), *twice),
            place_of(input, f));
    }
}

/// Coordinates between -1 and 1, so that products neither overflow nor vanish. Holes far outside
/// stay there.
MesherInput scaled(MesherInput input) {
    const double largest = input.points.size() == 0 ? 0.0 : input.points.cwiseAbs().maxCoeff();
    if (largest > 0.0) {
        constexpr double far = 1e3;
        input.points /= largest;
        input.holes = (input.holes / largest).cwiseMax(-far).cwiseMin(far).eval();
    }
    return input;
}

FacetPlane plane_of(const MesherInput& input, Index f) {
    const Facet corners = facet(input, f);
    const Points& places = input.points;
    FacetPlane plane{places.row(corners[0])}; // twice the area vector, after Newell
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Place here = places.row(corners[i]).transpose() - plane.origin;
        const Place next = places.row(corners[(i + 1) % corners.size()]).transpose() - plane.origin;
        plane.normal += here.cross(next);
        plane.size = std::max({plane.size, here.norm(), (next - here).norm()});
    }
    const bool is_flat = !(plane.normal.norm() > flat_tolerance * plane.size * plane.size);
    plane.normal = is_flat ? Place::Zero().eval() : plane.normal.normalized().eval();
    return plane;
}

void check_shape(const MesherInput& input, Index f) {
    const FacetPlane plane = plane_of(input, f);
    if (plane.normal.isZero()) {
        throw InvalidInput(fmt::format("mesher: facet {} has no area: its corners lie on one line",
                                       facet_name(input, f)),
                           place_of(input, f));
    }
    for (const Index corner : facet(input, f)) {
        const double height = plane.height(input.points.row(corner));
        if (height > bending_tolerance * plane.size) {
            throw InvalidInput(fmt::format("mesher: facet {} is not plane: its corner {} is off by "
                                           "{:.2g} of its size\nSplit it into triangles.",
                                           facet_name(input, f), corner, height / plane.size),
                               place_of(input, f));
        }
    }
}

void check_distinct(const Points& points, std::vector<Index> used) {
    const auto less = [&](Index a, Index b) {
        const auto p = points.row(a), q = points.row(b);
        return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
    };
    std::stable_sort(used.begin(), used.end(), less);
    const auto twin =
        std::adjacent_find(used.begin(), used.end(), [&](Index a, Index b) { return !less(a, b); });
    if (twin != used.end()) {
        throw InvalidInput(fmt::format("mesher: points {} and {} are both at ({}, {}, {}): join "
                                       "them",
                                       twin[0], twin[1], points(*twin, 0), points(*twin, 1),
                                       points(*twin, 2)));
    }
}

/// The point where a measure is largest, and the measure there.
template <typename Measure>
std::pair<Index, double> farthest(const std::vector<Index>& used, Measure measure) {
    std::pair<Index, double> best{used.front(), -1.0};
    for (const Index point : used) {
        const double value = measure(point);
        if (value > best.second)
            best = {point, value};
    }
    return best;
}

void check_not_coplanar(const Points& places, const std::vector<Index>& used) {
    const auto off = [&](Index i) -> Place {
        return (places.row(i) - places.row(used.front())).transpose();
    };
    const auto [second, length] = farthest(used, [&](Index i) { return off(i).norm(); });
    const Place along = off(second) / length;
    const auto [third, width] = farthest(used, [&](Index i) { return off(i).cross(along).norm(); });
    if (width <= flat_tolerance * length) {
        throw InvalidInput(fmt::format("mesher: all {} points lie on the line through points {} "
                                       "and {}: a volume needs points off it",
                                       used.size(), used.front(), second));
    }
    const Place normal = along.cross(off(third)).normalized();
    const auto height =
        farthest(used, [&](Index i) { return std::abs(off(i).dot(normal)); }).second;
    if (height <= flat_tolerance * length) {
        throw InvalidInput(fmt::format("mesher: all {} points lie in the plane through points {}, "
                                       "{} and {}: a volume needs points off it",
                                       used.size(), used.front(), second, third));
    }
}

void check_closed(const MesherInput& input) {
    const auto sides = sorted_sides(input.corners, input.offsets);
    std::string names;
    std::size_t bad = 0;
    for (auto begin = sides.begin(); begin != sides.end();) {
        const auto end = std::find_if(
            begin, sides.end(), [&](const PolygonSide& side) { return !side.beside(*begin); });
        if (end - begin != 2 && ++bad <= 3) {
            names += fmt::format("{}edge {} {} in {} (facet {})", bad == 1 ? "" : ", ", begin->low,
                                 begin->high, end - begin, begin->polygon);
        }
        begin = end;
    }
    if (bad > 0) {
        throw InvalidInput(fmt::format("mesher: the surface is not closed: each edge must be in "
                                       "two facets, but {} of them {} not\n{}{}\nClose the gaps, "
                                       "and take away facets that hang on or come twice.",
                                       bad, bad == 1 ? "is" : "are", names, bad > 3 ? " .." : ""));
    }
}

/// A hole says which part stays empty, so it must be clear where it is.
void check_holes(const MesherInput& input, const ClosedSurfaces& surfaces) {
    for (Eigen::Index hole = 0; hole < input.holes.rows(); ++hole) {
        const auto turns = windings(input.points, input.corners, input.offsets, surfaces,
                                    input.holes.row(hole).transpose());
        const bool is_on_surface = std::ranges::any_of(turns, [](double part) {
            return std::abs(part - std::round(part)) > winding_tolerance;
        });
        if (is_on_surface) {
            throw InvalidInput(
                fmt::format("mesher: hole {} is on a facet: move it to the inside", hole));
        }
        if (std::ranges::all_of(turns, [](double part) { return std::round(part) == 0.0; })) {
            throw InvalidInput(fmt::format("mesher: hole {} is outside of all surfaces: move it to "
                                           "the inside of the part that is to stay empty, or take "
                                           "it away",
                                           hole));
        }
    }
}

void check_sides(const MesherInput& input) {
    const auto surfaces = closed_surfaces(input.points, input.corners, input.offsets);
    if (surfaces.twisted >= 0) {
        throw InvalidInput(fmt::format("mesher: the surface at facet {} has one side only and "
                                       "encloses nothing",
                                       facet_name(input, surfaces.twisted)),
                           place_of(input, surfaces.twisted));
    }
    check_holes(input, surfaces);
}

} // namespace

Index facet_count(const MesherInput& input) {
    return input.offsets.empty() ? 0 : static_cast<Index>(input.offsets.size()) - 1;
}

std::vector<Index> used_points(const MesherInput& input) {
    std::vector<Index> used = input.corners;
    if (facet_count(input) == 0) {
        used.resize(static_cast<std::size_t>(input.points.rows()));
        std::iota(used.begin(), used.end(), Index{0});
        return used;
    }
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    return used;
}

std::vector<FacetPlane> facet_planes(const MesherInput& input) {
    std::vector<FacetPlane> planes;
    planes.reserve(static_cast<std::size_t>(facet_count(input)));
    for (Index f = 0; f < facet_count(input); ++f)
        planes.push_back(plane_of(input, f));
    return planes;
}

std::vector<Index> plane_patches(const MesherInput& given) {
    const MesherInput input = scaled(given);
    const auto planes = facet_planes(input);
    const auto count = planes.size();
    std::vector<std::vector<Index>> beside(count);
    const auto sides = sorted_sides(input.corners, input.offsets);
    for (std::size_t i = 0; i + 1 < sides.size(); ++i) {
        if (sides[i].beside(sides[i + 1])) {
            beside[static_cast<std::size_t>(sides[i].polygon)].push_back(sides[i + 1].polygon);
            beside[static_cast<std::size_t>(sides[i + 1].polygon)].push_back(sides[i].polygon);
        }
    }

    std::vector<Index> patches(count, -1);
    std::vector<Index> open;
    for (Index seed = 0; seed < facet_count(input); ++seed) {
        const FacetPlane& plane = planes[static_cast<std::size_t>(seed)];
        const auto is_in_plane = [&](Index f) {
            const double size = planes[static_cast<std::size_t>(f)].size;
            const double most = bending_tolerance * std::min(plane.size, size);
            return std::ranges::all_of(facet(input, f), [&](Index corner) {
                return plane.height(input.points.row(corner)) <= most;
            });
        };
        const auto take = [&](Index f) {
            if (patches[static_cast<std::size_t>(f)] < 0 && (f == seed || is_in_plane(f))) {
                patches[static_cast<std::size_t>(f)] = seed;
                open.push_back(f);
            }
        };
        take(seed);
        while (!open.empty()) {
            const auto here = static_cast<std::size_t>(open.back());
            open.pop_back();
            for (const Index f : beside[here])
                take(f);
        }
    }
    return patches;
}

std::string facet_name(const MesherInput& input, Index f) {
    constexpr std::size_t most = 6;
    const Facet corners = facet(input, f);
    return fmt::format("{} ({}{})", f,
                       fmt::join(corners.first(std::min(most, corners.size())), " "),
                       corners.size() > most ? " .." : "");
}

void check_mesher_options(const MesherOptions& options) {
    const double least_quality = std::sqrt(6.0) / 4.0; // of a regular tetrahedron
    const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
    if (options.quality != 0.0 &&
        !(positive(options.quality) && options.quality >= least_quality)) {
        throw InvalidInput(fmt::format("mesher: no tetrahedron has a circumradius of {} shortest "
                                       "edges, 0.613 is the least: ask for a quality of 1.2 or "
                                       "more, or 0 for none",
                                       options.quality));
    }
    if (options.largest_volume != 0.0 && !positive(options.largest_volume)) {
        throw InvalidInput(fmt::format("mesher: the largest volume {} is not positive; 0 means no "
                                       "bound",
                                       options.largest_volume));
    }
    if (!positive(options.seconds) || options.bytes == 0) {
        throw InvalidInput(fmt::format("mesher: {} seconds and {} bytes leave no room to work",
                                       options.seconds, options.bytes));
    }
}

void check_mesher_input(const MesherInput& input) {
    check_finite(input.points, "point");
    if (input.holes.rows() > 0)
        check_finite(input.holes, "hole");
    check_offsets(input);
    for (Index f = 0; f < facet_count(input); ++f)
        check_corners(input, f);
    if (facet_count(input) == 0 && input.holes.rows() > 0)
        throw InvalidInput("mesher: a point set has no holes; give facets that bound them");

    const auto used = used_points(input);
    if (used.size() < 4) {
        throw InvalidInput(
            fmt::format("mesher: there are {} points; a tetrahedron needs four", used.size()));
    }
    check_distinct(input.points, used);
    const MesherInput near_one = scaled(input);
    check_not_coplanar(near_one.points, used);
    for (Index f = 0; f < facet_count(input); ++f)
        check_shape(near_one, f);
    check_closed(input);
    check_sides(near_one);
}

} // namespace polydec
