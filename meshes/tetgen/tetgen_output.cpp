// SPDX-License-Identifier: MIT
#include "meshes/tetgen/tetgen_output.h"

#include "base/errors.h"
#include "complex/faces.h"
#include "meshes/tetgen/tetrahedron_sign.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace polydec {

namespace {

// Patches may be bent by that much, and all that follows is exact but for rounding.
constexpr double patch_tolerance = 10 * plane_tolerance;

[[noreturn]] void refuse_output(const std::string& what) {
    throw SolverFailure(fmt::format("tetgen did not return the requested mesh: {}\n"
                                    "Check that the program tetgen on PATH is the mesher TetGen.",
                                    what));
}

std::string cell_name(const TetgenOutput& output, Index cell) {
    const auto corners = output.tetrahedra.row(cell);
    return fmt::format("tetrahedron {} ({} {} {} {})", cell, corners[0], corners[1], corners[2],
                       corners[3]);
}

bool are_corners(const Simplices& list, Eigen::Index columns, Eigen::Index points) {
    return list.rows() > 0 && list.cols() == columns && list.minCoeff() >= 0 &&
           list.maxCoeff() < points;
}

void check_form(const TetgenInput& input, const TetgenOutput& output) {
    const auto& [points, tetrahedra, faces, facets] = output;
    const bool good =
        points.cols() == 3 && points.allFinite() && are_corners(tetrahedra, 4, points.rows()) &&
        are_corners(faces, 3, points.rows()) && std::cmp_equal(faces.rows(), facets.size()) &&
        std::all_of(facets.begin(), facets.end(),
                    [&](Index facet) { return facet >= 0 && facet < input.triangles.rows(); });
    if (!good)
        refuse_output("there are no tetrahedra, or numbers of points or facets that do not exist");
}

void check_points_kept(const TetgenInput& input, const TetgenOutput& output) {
    for (Eigen::Index i = 0; i < input.points.rows(); ++i) {
        const auto given = input.points.row(i);
        if (i >= output.points.rows() || output.points.row(i) != given)
            throw SolverFailure(fmt::format(
                "tetgen left out point {} at ({}, {}, {})\n"
                "Probable cause: its distance from another point is below 1e-8 of the size of the "
                "whole, or it lies in a hole; join it or move it.",
                input.vertices[i], std::ldexp(given[0], input.exponent),
                std::ldexp(given[1], input.exponent), std::ldexp(given[2], input.exponent)));
    }
}

double sum_of_positive_volumes(const TetgenOutput& output) {
    double sum = 0.0;
    for (Index cell = 0; cell < output.tetrahedra.rows(); ++cell) {
        const auto corner = [&](int i) -> Eigen::Vector3d {
            return output.points.row(output.tetrahedra(cell, i));
        };
        const int sign = tetrahedron_sign(corner(0), corner(1), corner(2), corner(3));
        if (sign <= 0)
            refuse_output(fmt::format("{} is {}", cell_name(output, cell),
                                      sign < 0 ? "turned inside out" : "flat"));
        sum +=
            (corner(1) - corner(0)).cross(corner(2) - corner(0)).dot(corner(3) - corner(0)) / 6.0;
    }
    return sum;
}

/// Each face lies in the plane of its patch, and together they have its area.
void check_planes(const TetgenInput& input, const TetgenOutput& output) {
    std::vector<double> areas(input.patches.size(), 0.0), found = areas;
    for (Index f = 0; f < input.triangles.rows(); ++f)
        areas[input.patches[f]] += triangle_plane(input.points, input.triangles, f).area;
    for (Index i = 0; i < output.faces.rows(); ++i) {
        const Index facet = output.facets[i];
        const Index patch = input.patches[facet];
        const auto plane = triangle_plane(input.points, input.triangles, patch);
        found[patch] += triangle_plane(output.points, output.faces, i).area;
        for (const Index corner : output.faces.row(i)) {
            if (plane.height(output.points.row(corner)) > patch_tolerance * plane.size)
                refuse_output(fmt::format(
                    "tetgen reports point {} on facet {}, but the point is off its plane", corner,
                    facet_name(input.given, facet)));
        }
    }
    for (std::size_t f = 0; f < areas.size(); ++f) {
        if (std::abs(found[f] - areas[f]) > patch_tolerance * areas[f])
            refuse_output(fmt::format("facet {} is covered {:.9g} times",
                                      facet_name(input.given, static_cast<Index>(f)),
                                      found[f] / areas[f]));
    }
}

/// The faces on the surface as one of their own.
ClosedSurface closed_faces(const TetgenOutput& output) {
    auto result = closed_surface(output.points, output.faces);
    if (!result.odd_edges.empty() || result.twisted >= 0)
        refuse_output(fmt::format("the faces on the facets do not close at point {}",
                                  result.twisted >= 0 ? output.faces(result.twisted, 0)
                                                      : result.odd_edges.front().low));
    return result;
}

/// Each part of the faces' surface is one part of the input's.
void check_parts(const TetgenInput& input, const TetgenOutput& output, const ClosedSurface& faces) {
    std::vector<Index> match(faces.volumes.size(), -1);
    bool fits = match.size() == input.surface.volumes.size();
    for (std::size_t i = 0; i < output.facets.size(); ++i) {
        Index& there = match[faces.part[i]];
        const Index part = input.surface.part[output.facets[i]];
        fits = fits && (there < 0 || there == part);
        there = part;
    }
    if (!fits)
        refuse_output("the faces on the facets form other surfaces than the facets");
}

/// Where tetrahedra are.
struct Filling {
    struct Sides {
        bool inner = false, outer = false;
    };
    std::vector<Sides> at_faces; ///< inside and outside of the surface that each face is on
    bool ends_elsewhere = false; ///< a face of one tetrahedron alone is not on the surface
};

/// Throws unless there is at most one tetrahedron on either side of each face.
Filling filling_of(const TetgenOutput& output, const ClosedSurface& surface) {
    constexpr int outward[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
    const auto of_cells = static_cast<Index>(4 * output.tetrahedra.rows());
    Simplices faces(of_cells + output.faces.rows(), 3);
    for (Index i = 0; i < of_cells; ++i)
        for (int j = 0; j < 3; ++j)
            faces(i, j) = output.tetrahedra(i / 4, outward[i % 4][j]);
    faces.bottomRows(output.faces.rows()) = output.faces;
    const auto sorted = sorted_rows(faces, static_cast<Index>(output.points.rows()));
    const Simplices& rows = *sorted.simplices.rows;

    Filling result{std::vector<Filling::Sides>(output.facets.size())};
    for (Index begin = 0, end = 0; begin < rows.rows(); begin = end) {
        std::array<Index, 2> cells{-1, -1}; // by the sense in which their boundaries run around it
        Index on_surface = -1, outside = 0; // the sense of a cell there
        for (end = begin; end < rows.rows() && rows.row(end) == rows.row(begin); ++end) {
            const Index i = sorted.order[end];
            const int sign = sorted.signs[end];
            if (i >= of_cells) {
                on_surface = i - of_cells;
                outside = sign * surface.sense[on_surface] > 0 ? 0 : 1;
                continue;
            }
            Index& cell = cells[sign > 0 ? 1 : 0];
            if (cell >= 0)
                refuse_output(fmt::format("{} and {} are on the same side of a face",
                                          cell_name(output, std::min(cell, i / 4)),
                                          cell_name(output, std::max(cell, i / 4))));
            cell = i / 4;
        }
        if (on_surface >= 0)
            result.at_faces[on_surface] = {cells[1 - outside] >= 0, cells[outside] >= 0};
        else if (cells[0] < 0 || cells[1] < 0)
            result.ends_elsewhere = true;
    }
    return result;
}

/// Compares what is filled with what should be, and returns the volume that it then has.
double check_filled(const TetgenInput& input, const TetgenOutput& output,
                    const ClosedSurface& faces) {
    const auto filling = filling_of(output, faces);
    std::vector<int> shares(input.filled.size(), 0); // of the enclosed volume, by the last face
    for (std::size_t i = 0; i < output.facets.size(); ++i) {
        const Index facet = output.facets[i];
        const Index part = input.surface.part[facet];
        const auto [inner, outer] = filling.at_faces[i];
        if (inner != input.filled[part])
            refuse_output(fmt::format("the inside at facet {} is {}",
                                      facet_name(input.given, facet),
                                      inner ? "filled in spite of a hole" : "left empty"));
        shares[part] = static_cast<int>(inner) - static_cast<int>(outer);
    }
    if (filling.ends_elsewhere)
        refuse_output("some faces of the boundary lie on no facet");
    double volume = 0.0;
    for (std::size_t part = 0; part < shares.size(); ++part)
        volume += shares[part] * input.surface.volumes[part];
    return volume;
}

} // namespace

void check_tetgen_output(const TetgenInput& input, const TetgenOutput& output) {
    check_form(input, output);
    check_points_kept(input, output);
    const double volume = sum_of_positive_volumes(output);
    const auto faces = closed_faces(output);
    check_planes(input, output);
    check_parts(input, output, faces);
    const double enclosed = check_filled(input, output, faces);
    if (!(std::abs(enclosed - volume) <= patch_tolerance * input.surface.reach))
        refuse_output(fmt::format("the tetrahedra have volume {:.12g}, but the surface encloses "
                                  "{:.12g}, in units of a power of two near the size of the whole",
                                  volume, enclosed));
}

} // namespace polydec
