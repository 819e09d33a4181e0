// SPDX-License-Identifier: MIT
#include "meshes/tetgen/tetgen_input.h"

#include "base/checks.h"
#include "base/errors.h"
#include "base/listed.h"
#include "base/lists.h"
#include "meshes/edges.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace polydec {

namespace {

constexpr double height_tolerance = 1e-12; // of triangles and of the whole, relative to lengths
constexpr double winding_tolerance = 1e-6; // of holes that are off the surface

void check_finite(const Points& points, const char* kind) {
    if (points.rows() > 0 && points.cols() != 3)
        throw InvalidInput(
            fmt::format("mesher: a {} has {} coordinates; expected three", kind, points.cols()));
    for (Eigen::Index i = 0; i < points.rows(); ++i) {
        if (!points.row(i).allFinite())
            throw InvalidInput(fmt::format("mesher: {} {} is at ({}, {}, {}): coordinates must be "
                                           "finite",
                                           kind, i, points(i, 0), points(i, 1), points(i, 2)));
    }
}

[[noreturn]] void refuse(const std::string& text, const Simplices& given, Index f) {
    const auto corners = given.row(f);
    throw InvalidInput(text,
                       {.degree = 2, .cells = {f}, .vertices = {corners.begin(), corners.end()}});
}

void check_corners(const Mesh& surface) {
    const auto& given = surface.simplices;
    for (Index f = 0; f < given.rows(); ++f) {
        for (int j = 0; j < 3; ++j) {
            const Index corner = given(f, j);
            if (corner < 0 || corner >= surface.points.rows())
                refuse(fmt::format("mesher: facet {} has the corner {}; {}", f, corner,
                                   expected_numbers(0, surface.points.rows() - 1)),
                       given, f);
            if (corner == given(f, (j + 1) % 3))
                refuse(fmt::format("mesher: facet {} has the corner {} twice", facet_name(given, f),
                                   corner),
                       given, f);
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
    if (twin != used.end())
        throw InvalidInput(fmt::format("mesher: points {} and {} are both at ({}, {}, {}): join "
                                       "them",
                                       twin[0], twin[1], points(*twin, 0), points(*twin, 1),
                                       points(*twin, 2)));
}

/// Moves points and holes to a unit near the surface's size. Holes far outside stay there.
void scale(TetgenInput& input) {
    constexpr double far = 1e3;
    const double largest = input.points.cwiseAbs().maxCoeff();
    input.exponent = largest > 0.0 ? std::ilogb(largest) : 0;
    const auto scaled = [&](double x) { return std::ldexp(x, -input.exponent); };
    input.points = input.points.unaryExpr(scaled).eval();
    input.holes = input.holes.unaryExpr(scaled).cwiseMax(-far).cwiseMin(far).eval();
}

void check_areas(const TetgenInput& input) {
    for (Index f = 0; f < input.triangles.rows(); ++f)
        if (triangle_plane(input.points, input.triangles, f).normal.isZero())
            refuse(fmt::format("mesher: facet {} has no area: its corners lie on one line",
                               facet_name(input.given, f)),
                   input.given, f);
}

void check_not_coplanar(const TetgenInput& input) {
    const Points off = input.points.rowwise() - input.points.row(0);
    Eigen::Index second = 0, third = 0;
    const double length = off.rowwise().norm().maxCoeff(&second);
    const Eigen::RowVector3d along = off.row(second) / length;
    const Points beside = off - (off * along.transpose()) * along;
    beside.rowwise().norm().maxCoeff(&third);
    const Eigen::RowVector3d width = beside.row(third);
    const Eigen::Vector3d normal = along.cross(width).normalized();
    if ((off * normal).cwiseAbs().maxCoeff() <= height_tolerance * length) {
        throw InvalidInput(fmt::format("mesher: all {} points lie in the plane through points {}, "
                                       "{} and {}: expected a point off this plane",
                                       off.rows(), input.vertices[0], input.vertices[second],
                                       input.vertices[third]));
    }
}

void check_closed(const TetgenInput& input) {
    const auto& odd = input.surface.odd_edges;
    if (odd.empty())
        return;
    const auto name = [&](Index i) {
        return fmt::format("edge {} {} in {} (facet {})", input.vertices[odd[i].low],
                           input.vertices[odd[i].high], odd[i].triangles, odd[i].first);
    };
    throw InvalidInput(fmt::format(
        "mesher: the surface is not closed: each edge must be in two facets, but {} of "
        "them {} not\n{}\nClose the gaps, and remove dangling and repeated facets.",
        odd.size(), odd.size() == 1 ? "is" : "are", listed(numbers_below(std::ssize(odd)), name)));
}

void check_sides(const TetgenInput& input) {
    if (const Index f = input.surface.twisted; f >= 0)
        refuse(fmt::format("mesher: the surface at facet {} has only one side and encloses nothing",
                           facet_name(input.given, f)),
               input.given, f);
}

/// A hole says which part stays empty, so it must be clear where it is.
void empty_holes(TetgenInput& input) {
    const auto& volumes = input.surface.volumes;
    input.filled.assign(volumes.size(), true);
    for (Eigen::Index hole = 0; hole < input.holes.rows(); ++hole) {
        const auto turns =
            windings(input.points, input.triangles, input.surface, input.holes.row(hole));
        const bool is_on_surface = std::ranges::any_of(turns, [](double part) {
            return std::abs(part - std::round(part)) > winding_tolerance;
        });
        if (is_on_surface)
            throw InvalidInput(
                fmt::format("mesher: hole {} is on a facet: move it to the inside", hole));
        std::size_t innermost = volumes.size();
        for (std::size_t part = 0; part < volumes.size(); ++part) {
            const bool is_around = std::round(turns[part]) != 0.0;
            if (is_around && (innermost == volumes.size() || volumes[part] < volumes[innermost]))
                innermost = part;
        }
        if (innermost == volumes.size())
            throw InvalidInput(fmt::format("mesher: hole {} is outside all surfaces: move it "
                                           "inside the part to leave empty, or remove it",
                                           hole));
        input.filled[innermost] = false;
    }
}

std::vector<Index> plane_patches(const TetgenInput& input) {
    const auto count = static_cast<Index>(input.triangles.rows());
    std::vector<Index> patches(count, -1), open;
    for (Index seed = 0; seed < count; ++seed) {
        const auto plane = triangle_plane(input.points, input.triangles, seed);
        const auto is_in_plane = [&](Index f) {
            const double size = triangle_plane(input.points, input.triangles, f).size;
            const double most = plane_tolerance * std::min(plane.size, size);
            return std::ranges::all_of(input.triangles.row(f), [&](Index corner) {
                return plane.height(input.points.row(corner)) <= most;
            });
        };
        const auto take = [&](Index f) {
            if (patches[f] < 0 && (f == seed || is_in_plane(f))) {
                patches[f] = seed;
                open.push_back(f);
            }
        };
        take(seed);
        while (!open.empty()) {
            const Index here = open.back();
            open.pop_back();
            for (const Index f : input.surface.across.row(here))
                take(f);
        }
    }
    return patches;
}

} // namespace

TetgenInput tetgen_input(const Mesh& surface, const Points& holes) {
    check_finite(surface.points, "point");
    check_finite(holes, "hole");
    check_corners(surface);

    TetgenInput input;
    input.vertices = used_vertices(surface.simplices);
    if (input.vertices.size() < 4)
        throw InvalidInput(fmt::format("mesher: there are {} points; a tetrahedron needs four",
                                       input.vertices.size()));
    check_distinct(surface.points, input.vertices);
    input.points = surface.points(input.vertices, Eigen::indexing::all);
    input.holes = holes;
    input.given = surface.simplices;
    scale(input);
    input.triangles =
        surface.simplices.unaryExpr([&](Index vertex) { return place_in(input.vertices, vertex); });

    check_areas(input);
    check_not_coplanar(input);
    input.surface = closed_surface(input.points, input.triangles);
    check_closed(input);
    check_sides(input);
    empty_holes(input);
    input.patches = plane_patches(input);
    return input;
}

TrianglePlane triangle_plane(const Points& points, const Simplices& triangles, Index triangle) {
    const auto corner = [&](int j) -> Eigen::Vector3d {
        return points.row(triangles(triangle, j));
    };
    const Eigen::Vector3d origin = corner(0), a = corner(1) - origin, b = corner(2) - origin;
    const Eigen::Vector3d normal = a.cross(b);
    const double size = std::max({a.norm(), b.norm(), (b - a).norm()});
    const bool is_flat = !(normal.norm() > height_tolerance * size * size);
    return {origin, is_flat ? Eigen::Vector3d::Zero().eval() : normal.normalized(), size,
            normal.norm() / 2.0};
}

std::string facet_name(const Simplices& given, Index triangle) {
    return fmt::format("{} ({} {} {})", triangle, given(triangle, 0), given(triangle, 1),
                       given(triangle, 2));
}

} // namespace polydec
