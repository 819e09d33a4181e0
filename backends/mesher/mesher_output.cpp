// SPDX-License-Identifier: MIT
#include "backends/mesher/mesher_output.h"

#include "backends/mesher/closed_surfaces.h"
#include "backends/mesher/mesher_input.h"
#include "backends/mesher/polygon_sides.h"
#include "backends/mesher/tetrahedron_sign.h"
#include "base/errors.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace polydec {

namespace {

using Place = Eigen::Vector3d;

constexpr double hull_tolerance = 1e-9; // of volumes

Points scaled(const Points& points, int exponent) {
    return points.unaryExpr([exponent](double x) { return std::ldexp(x, exponent); });
}

bool are_corners(const Simplices& list, Eigen::Index columns, Eigen::Index points) {
    return list.size() == 0
               ? list.rows() == 0
               : list.cols() == columns && list.minCoeff() >= 0 && list.maxCoeff() < points;
}

void check_form(const MesherResult& result) {
    const auto& [points, tetrahedra, faces, facets] = result.output;
    const bool good =
        points.cols() == 3 && points.allFinite() && tetrahedra.rows() > 0 &&
        are_corners(tetrahedra, 4, points.rows()) && are_corners(faces, 3, points.rows()) &&
        std::cmp_equal(faces.rows(), facets.size()) &&
        std::all_of(facets.begin(), facets.end(),
                    [&](Index facet) { return facet >= 0 && facet < facet_count(result.input); });
    if (!good)
        result.fail("there are no tetrahedra, or numbers of points or facets that do not exist");
}

void check_points_kept(const MesherResult& result) {
    const auto& made = result.output.points;
    for (std::size_t i = 0; i < result.used.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        const auto given = result.input.points.row(result.used[i]);
        if (row >= made.rows() || made.row(row) != given) {
            throw SolverFailure(fmt::format(
                "{} left out point {} at ({}, {}, {})\nProbable cause: it is nearer to another "
                "point than 1e-8 of the whole, or within a hole; join it or move it.",
                result.engine, result.used[i], std::ldexp(given[0], result.exponent),
                std::ldexp(given[1], result.exponent), std::ldexp(given[2], result.exponent)));
        }
    }
}

double sum_of_positive_volumes(const MesherResult& result) {
    const Points& points = result.output.points;
    const Simplices& tetrahedra = result.output.tetrahedra;
    double sum = 0.0;
    for (Index cell = 0; cell < tetrahedra.rows(); ++cell) {
        const auto corner = [&](int i) -> Place { return points.row(tetrahedra(cell, i)); };
        const int sign = tetrahedron_sign(corner(0), corner(1), corner(2), corner(3));
        if (sign <= 0) {
            result.fail(fmt::format("{} is {}", result.cell_name(cell),
                                    sign < 0 ? "turned inside out" : "flat"));
        }
        sum +=
            (corner(1) - corner(0)).cross(corner(2) - corner(0)).dot(corner(3) - corner(0)) / 6.0;
    }
    return sum;
}

std::vector<OutwardFace> sorted_faces(const Simplices& tetrahedra) {
    constexpr int outward[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
    std::vector<OutwardFace> faces;
    faces.reserve(4 * static_cast<std::size_t>(tetrahedra.rows()));
    for (Index cell = 0; cell < tetrahedra.rows(); ++cell) {
        for (const auto& [i, j, k] : outward) {
            faces.push_back(
                {{tetrahedra(cell, i), tetrahedra(cell, j), tetrahedra(cell, k)}, cell, true});
            sort_corners(faces.back());
        }
    }
    std::stable_sort(faces.begin(), faces.end(), [](const OutwardFace& a, const OutwardFace& b) {
        return a.corners < b.corners;
    });
    return faces;
}

void check_sides(const MesherResult& result) {
    const auto& faces = result.faces;
    for (std::size_t i = 0; i + 1 < faces.size(); ++i) {
        for (std::size_t j = i + 1; j < faces.size() && faces[j].corners == faces[i].corners; ++j) {
            if (faces[j].is_ascending == faces[i].is_ascending) {
                result.fail(fmt::format("{} and {} are on the same side of a face",
                                        result.cell_name(faces[i].cell),
                                        result.cell_name(faces[j].cell)));
            }
        }
    }
}

/// The corners of the faces that are in one tetrahedron, turned outward.
std::vector<Index> boundary_corners(const std::vector<OutwardFace>& faces) {
    std::vector<Index> corners;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const auto is_same = [&](std::size_t j) { return faces[j].corners == faces[i].corners; };
        if ((i > 0 && is_same(i - 1)) || (i + 1 < faces.size() && is_same(i + 1)))
            continue;
        auto [a, b, c] = faces[i].corners;
        if (!faces[i].is_ascending)
            std::swap(b, c);
        corners.insert(corners.end(), {a, b, c});
    }
    return corners;
}

/// A closed surface that is convex along each of its edges bounds a convex body.
void check_hull(const MesherResult& result) {
    const auto& points = result.output.points;
    const auto corners = boundary_corners(result.faces);
    std::vector<Index> offsets;
    for (std::size_t i = 0; i <= corners.size(); i += 3)
        offsets.push_back(static_cast<Index>(i));
    const auto hull = closed_surfaces(points, corners, offsets);
    if (hull.odd_edge >= 0 || hull.twisted >= 0 || hull.volumes.size() != 1)
        result.fail("the boundary is not one closed surface");
    if (std::abs(hull.volumes[0] - result.volume) > hull_tolerance * hull.reach) {
        result.fail(fmt::format("the tetrahedra have the volume {:.12g} and their boundary "
                                "encloses {:.12g}",
                                result.volume, hull.volumes[0]));
    }
    const auto sides = sorted_sides(corners, offsets);
    for (std::size_t i = 0; i + 1 < sides.size(); i += 2) {
        const auto corner = [&](Index face, int j) -> Place {
            return points.row(corners[static_cast<std::size_t>(3 * face + j)]);
        };
        const Place origin = corner(sides[i].polygon, 0);
        const Place area =
            (corner(sides[i].polygon, 1) - origin).cross(corner(sides[i].polygon, 2) - origin);
        for (int j = 0; j < 3; ++j) {
            if (area.dot(corner(sides[i + 1].polygon, j) - origin) > hull_tolerance * hull.reach) {
                result.fail(fmt::format("the boundary is not convex between points {} and {}",
                                        sides[i].low, sides[i].high));
            }
        }
    }
}

} // namespace

void MesherResult::fail(const std::string& what) const {
    throw SolverFailure(fmt::format("what {} made is not the mesh that was asked for: {}\n"
                                    "Is the program of that name on PATH the mesher?",
                                    engine, what));
}

void sort_corners(OutwardFace& face) {
    auto& corners = face.corners;
    for (const auto& [i, j] : {std::pair<std::size_t, std::size_t>{0, 1}, {1, 2}, {0, 1}}) {
        if (corners[i] > corners[j]) {
            std::swap(corners[i], corners[j]);
            face.is_ascending = !face.is_ascending;
        }
    }
}

std::size_t boundary_size(const std::vector<OutwardFace>& faces) {
    return boundary_corners(faces).size() / 3;
}

std::string MesherResult::cell_name(Index cell) const {
    const auto corners = output.tetrahedra.row(cell);
    return fmt::format("tetrahedron {} ({} {} {} {})", cell, corners[0], corners[1], corners[2],
                       corners[3]);
}

void check_mesher_output(const MesherInput& input, const std::string& engine,
                         MesherOutput& output) {
    const double largest = input.points.cwiseAbs().maxCoeff();
    const int exponent = largest > 0.0 ? std::ilogb(largest) : 0;
    MesherInput given = input;
    given.points = scaled(input.points, -exponent);
    given.holes = scaled(input.holes, -exponent);
    MesherOutput made = output;
    made.points = scaled(output.points, -exponent);

    MesherResult result{given, made, engine, exponent, used_points(input), {}, 0.0};
    check_form(result);
    check_points_kept(result);
    result.volume = sum_of_positive_volumes(result);
    result.faces = sorted_faces(made.tetrahedra);
    check_sides(result);
    if (facet_count(input) == 0)
        check_hull(result);
    else
        check_facets_filled(result);
    for (std::size_t i = 0; i < result.used.size(); ++i)
        output.points.row(static_cast<Eigen::Index>(i)) = input.points.row(result.used[i]);
}

} // namespace polydec
