// SPDX-License-Identifier: MIT
//
// Draws cells and duals for the pages of docs/. Usage: drawings FOLDER.
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <numbers>
#include <polydec.h>
#include <string>
#include <vector>

namespace {

using polydec::SvgDrawing;
using Corners = std::vector<std::array<double, 2>>;

/// Triangles between these points in the plane.
polydec::Mesh mesh_of(const Corners& points, const std::vector<std::array<int, 3>>& triangles) {
    polydec::Mesh mesh{
        polydec::Points(std::ssize(points), 2), polydec::Simplices(std::ssize(triangles), 3), {}};
    for (std::size_t i = 0; i < points.size(); ++i)
        mesh.points.row(static_cast<polydec::Index>(i)) << points[i][0], points[i][1];
    for (std::size_t i = 0; i < triangles.size(); ++i)
        mesh.simplices.row(static_cast<polydec::Index>(i)) << triangles[i][0], triangles[i][1],
            triangles[i][2];
    return mesh;
}

std::array<double, 2> on_circle(double radius, double degrees) {
    const double angle = degrees * std::numbers::pi / 180;
    return {radius * std::cos(angle), radius * std::sin(angle)};
}

SvgDrawing panel(const polydec::Mesh& input, const std::string& title, double width,
                 polydec::StructureOptions options, bool merge = true) {
    options.view.title = title;
    options.view.width = width;
    options.words = false;
    const auto criterion = polydec::MergeOptions{}.criterion;
    return polydec::draw_structure(
        polydec::discretize(input, {merge ? criterion : polydec::MergeCriterion::none}), options);
}

/// Drawings in a row above a legend of their lines.
SvgDrawing row_of(const std::vector<SvgDrawing>& panels, const std::string& words) {
    SvgDrawing row = polydec::side_by_side(panels);
    double bottom = 0;
    for (const auto& shape : row.shapes)
        if (const auto* polygon = std::get_if<polydec::SvgPolygon>(&shape))
            for (const auto& point : polygon->points)
                bottom = std::min(bottom, point[1]);
        else if (const auto* circle = std::get_if<polydec::SvgCircle>(&shape))
            bottom = std::min(bottom, circle->center[1] - circle->radius);
        else if (const auto* dot = std::get_if<polydec::SvgDot>(&shape))
            bottom = std::min(bottom, dot->center[1]);
    row.shapes.emplace_back(polydec::SvgText{
        {row.width / 2 - row.margin, bottom - 34}, words, 14, polydec::SvgAnchor::middle});
    return row;
}

/// Text to the right of a point.
polydec::SvgText label(double x, double y, const std::string& text, const char* color = "#222222") {
    return {{x, y}, text, 15, polydec::SvgAnchor::start, color};
}

/// Two oriented triangles, and the boundary of their sum.
SvgDrawing chain() {
    const auto square = mesh_of({{0, 0}, {1, 0}, {0, 1}, {1, 1}}, {{0, 1, 2}, {1, 3, 2}});
    SvgDrawing sum =
        panel(square, "two cells", 300, {.numbers = true, .orientations = true}, false);
    SvgDrawing rim = panel(square, "the boundary of their sum", 300, {}, false);
    const auto mesh = polydec::discretize(square, {polydec::MergeCriterion::none});
    std::vector<int> boundary(static_cast<std::size_t>(mesh.complex().size(1)), 0);
    for (polydec::Index cell = 0; cell < mesh.complex().size(2); ++cell)
        for (const auto& [edge, sign] : mesh.complex().incidences(1)[cell])
            boundary[edge] += sign;
    for (polydec::Index edge = 0; edge < mesh.complex().size(1); ++edge) {
        Eigen::RowVector2d middle = Eigen::RowVector2d::Zero(), along = middle;
        for (const auto& [vertex, sign] : mesh.complex().incidences(0)[edge]) {
            middle += mesh.points().row(vertex) / 2;
            along += sign * mesh.points().row(vertex);
        }
        const Eigen::RowVector2d from = middle - 0.45 * along, to = middle + 0.45 * along;
        const Eigen::RowVector2d away = 0.2 * (middle - Eigen::RowVector2d(0.5, 0.5));
        if (boundary[edge] != 0)
            rim.shapes.emplace_back(polydec::SvgArrow{
                {from[0], from[1]}, {to[0], to[1]}, {.stroke = "#D55E00", .width = 3}});
        const polydec::SvgPoint at{middle[0] - away[0], middle[1] - away[1] - 0.02};
        const std::string coefficient = boundary[edge] > 0   ? "+1"
                                        : boundary[edge] < 0 ? "\u22121"
                                                             : "0";
        rim.shapes.emplace_back(
            polydec::SvgText{at, coefficient, 15, polydec::SvgAnchor::middle, "#B34700"});
    }
    return row_of({sum, rim}, "numbers of vertices (black), edges (orange) and cells (purple)");
}

/// Six triangles around vertex 0.
polydec::Mesh fan() {
    Corners corners{{0.03, -0.02}};
    for (const auto& [radius, degrees] : std::vector<std::array<double, 2>>{
             {1, 10}, {0.95, 75}, {1.1, 130}, {0.9, 190}, {1.05, 250}, {0.95, 310}})
        corners.push_back(on_circle(radius, degrees));
    return mesh_of(corners, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}, {0, 5, 6}, {0, 6, 1}});
}

/// A dual cell, the orientations of dual edges, and the boundary matrix of the edges.
SvgDrawing lesson() {
    polydec::LessonOptions options{.matrix = 1};
    options.structure = {
        .dual_orientations = true, .cell = 0, .numbers = true, .orientations = true};
    options.structure.view.width = 480;
    return polydec::draw_lesson(polydec::discretize(fan()), options);
}

/// The dual cell of a vertex, and dual edges of either sign.
SvgDrawing dual_cell() {
    SvgDrawing acute = panel(mesh_of({{0, 0}, {1.75, 0}, {1, 1.15}}, {{0, 1, 2}}), "h(s,t) > 0",
                             250, {.duals = true});
    SvgDrawing obtuse = panel(mesh_of({{0, 0}, {1.75, 0}, {0.85, 0.5}}, {{0, 1, 2}}), "h(s,t) < 0",
                              250, {.duals = true});
    acute.shapes.insert(acute.shapes.end(), {label(0.95, 0.16, "c(t)"), label(1.45, 0.06, "s"),
                                             label(1.02, 0.82, "t")});
    obtuse.shapes.insert(obtuse.shapes.end(),
                         {label(0.95, -0.55, "c(t)"), label(1.4, 0.04, "s"), label(0.8, 0.3, "t")});
    return row_of({panel(fan(), "the dual cell of a vertex", 330, {.duals = true}), acute, obtuse},
                  "blue: dual edges between circumcenters; red: of negative length");
}

/// The four kinds of pairs of triangles.
SvgDrawing pair_kinds() {
    struct Kind {
        const char* name;
        std::array<double, 2> top, bottom;
    };
    const auto on_one_circle = [](double degrees) { // through (-1, 0) and (1, 0)
        const auto p = on_circle(std::hypot(1, 0.3), degrees);
        return std::array{p[0], p[1] + 0.3};
    };
    std::vector<SvgDrawing> panels;
    for (const auto& [name, top, bottom] :
         {Kind{"well-centered", {0.15, 1.45}, {-0.15, -1.3}},
          Kind{"Delaunay", {0.1, 1.75}, {-0.3, -0.8}},
          Kind{"concyclic", on_one_circle(75), on_one_circle(250)},
          Kind{"non-Delaunay", {0.2, 0.75}, {-0.2, -0.65}}})
        panels.push_back(panel(mesh_of({{-1, 0}, {1, 0}, top, bottom}, {{0, 1, 2}, {0, 3, 1}}),
                               name, 220, {.duals = true, .circumcircles = true}));
    return row_of(panels, "blue: dual edges; red: of negative length; dashed: merged away; dotted: "
                          "circumcircles");
}

/// Concyclic triangles and their merged cells.
SvgDrawing merged_polygons() {
    Corners quad, hexagon;
    for (const double degrees : {35, 140, 215, 330})
        quad.push_back(on_circle(1, degrees));
    for (const double degrees : {0, 55, 125, 180, 250, 300})
        hexagon.push_back(on_circle(1, degrees));
    const polydec::StructureOptions shown{.duals = true, .circumcircles = true};
    return row_of(
        {
            panel(mesh_of(quad, {{0, 1, 2}, {0, 2, 3}}), "2 triangles, 1 cell", 260, shown),
            panel(mesh_of(hexagon, {{0, 1, 2}, {2, 3, 4}, {2, 4, 5}, {0, 2, 5}}),
                  "4 triangles, 1 cell", 260, shown),
            panel(polydec::kuhn(2, 2), "8 triangles, 4 cells", 260, {.duals = true}),
        },
        "dashed: edges merged away; blue: dual edges; dotted: circumcircles");
}

/// Half dual edges at the boundary: positive, zero, negative.
SvgDrawing boundary_duals() {
    const auto half = on_circle(0.75, 75);
    struct Case {
        const char* title;
        std::array<double, 2> apex;
        std::vector<polydec::SvgText> labels;
    };
    std::vector<SvgDrawing> panels;
    for (const auto& [title, apex, labels] :
         {Case{"half a dual edge", {1.05, 1.3}, {label(0.84, 0.36, "u"), label(0.78, 0.06, "g")}},
          Case{"right angle: length 0", {0.75 + half[0], half[1]}, {label(0.7, -0.16, "u = g")}},
          Case{"obtuse: negative",
               {0.85, 0.42},
               {label(0.8, 0.05, "g"), label(0.81, -0.48, "u")}}}) {
        panels.push_back(
            panel(mesh_of({{0, 0}, {1.5, 0}, apex}, {{0, 1, 2}}), title, 260, {.duals = true}));
        panels.back().shapes.insert(panels.back().shapes.end(), labels.begin(), labels.end());
    }
    return row_of(panels, "the edge below is on the boundary: u at the cell's circumcenter, g at "
                          "that of the edge");
}

} // namespace

int main(int, char** arguments) {
    const std::filesystem::path folder = arguments[1] ? arguments[1] : ".";
    for (const auto& [name, drawing] :
         std::vector<std::pair<std::string, SvgDrawing>>{{"chain", chain()},
                                                         {"dual_cell", dual_cell()},
                                                         {"pair_kinds", pair_kinds()},
                                                         {"merged_polygons", merged_polygons()},
                                                         {"boundary_duals", boundary_duals()},
                                                         {"lesson", lesson()}}) {
        std::ofstream(folder / (name + ".svg")) << polydec::to_svg(drawing);
        std::cout << name << '\n';
    }
}
