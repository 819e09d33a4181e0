// SPDX-License-Identifier: MIT
//
// Fig. 2: pairs of triangles, by position of their circumcenters. The dual edge crosses the common
// edge or lies on one side of it; it is positive, negative or zero.
#include "examples/paper/pictures.h"
#include "examples/paper/problems.h"
#include "examples/paper/reproductions.h"
#include "io/pictures/structure_style.h"

#include <fmt/format.h>

#include <cmath>
#include <polydec.h>

namespace polydec::paper {

namespace {

/// Two triangles on the edge from (-1, 0) to (1, 0). Their circumcenters lie on the y axis, at the
/// given distances from the edge, positive towards the apex of the triangle.
struct Pair {
    std::string label;
    double upper, lower;
    SvgPoint shift; ///< in the drawing
};

const std::vector<Pair> pairs = {
    {"(a)", 0.6, 0.4, {0, 0}},      {"(b)", 0.8, -0.3, {0, -4.5}},    //
    {"(c)", -0.45, -0.3, {4.2, 0}}, {"(d)", 0.25, -0.8, {4.2, -4.5}}, //
    {"(e)", 0, 0, {8.4, 0}},        {"(f)", 0.55, -0.55, {8.4, -4.5}},
};

Mesh mesh_of(const Pair& pair) {
    // the apex may be anywhere on its circle; slightly beside the top is more generic
    const double turn = 0.35;
    const double up = std::hypot(1, pair.upper), down = std::hypot(1, pair.lower);
    Mesh mesh;
    mesh.points.resize(4, 2);
    mesh.points << -1, 0, 1, 0, -up * std::sin(turn), pair.upper + up * std::cos(turn),
        down * std::sin(turn), -pair.lower - down * std::cos(turn);
    mesh.simplices.resize(2, 3);
    mesh.simplices << 0, 1, 2, 1, 0, 3;
    return mesh;
}

constexpr Index common_edge = 0; // the edges of {0, 1}, {0, 2} .. are sorted

std::string kind(const Discretization& mesh) {
    const auto kinds = facet_kinds(mesh.input_geometry(), mesh.options());
    if (kinds.cospherical > 0)
        return "concyclic";
    if (kinds.non_delaunay > 0)
        return "non-Delaunay";
    return kinds.delaunay > 0 ? "Delaunay" : "well-centered";
}

void draw(SvgDrawing& drawing, const Pair& pair, const Discretization& mesh) {
    const auto at = [&](Index vertex) { return place(mesh.points(), vertex, pair.shift); };
    const SvgPoint upper{pair.shift[0], pair.shift[1] + pair.upper};
    const SvgPoint lower{pair.shift[0], pair.shift[1] - pair.lower};
    const bool merged = mesh.merging().carriers(1)[common_edge].dimension == 2;

    for (const auto& [center, apex] : {std::pair{upper, Index{2}}, {lower, Index{3}}}) {
        drawing.shapes.push_back(
            SvgPolygon{{at(0), at(1), at(apex)}, {.stroke = "none", .fill = face_color}});
        const double radius = std::hypot(1, center[1] - pair.shift[1]);
        drawing.shapes.push_back(
            SvgCircle{center, radius, {.stroke = gray, .width = 0.8, .dashes = {2, 3}}});
    }
    drawing.shapes.push_back(SvgPolygon{{at(0), at(2), at(1), at(3)}, {.width = 1.6}});
    SvgStyle edge{.width = 1.6};
    if (merged)
        edge.dashes = {6, 4};
    drawing.shapes.push_back(SvgPolyline{{at(0), at(1)}, edge});

    // from the lower triangle's center to the upper one's: up is the right way
    const double dual = mesh.input_geometry().volumes().dual(1)[common_edge];
    const char* color = merged ? black : dual < 0 ? negative_color : positive_color;
    drawing.shapes.push_back(SvgArrow{lower, upper, {.stroke = color, .width = 3}});
    for (const auto& center : {lower, upper})
        drawing.shapes.push_back(
            SvgDot{center, 4, {.stroke = color, .fill = "#ffffff", .width = 1.6}});
    const double below = pair.shift[1] - (pair.upper * pair.lower < 0 ? 1.3 : 2.0);
    drawing.shapes.push_back(
        SvgText{{pair.shift[0], below}, fmt::format("{} {}", pair.label, kind(mesh)), 15});
}

} // namespace

Report fig2(const Request&) {
    Table table{"pairs",
                "the common edge of each pair, of length 2",
                {"pair", "dual edge", "kind", "dual length", "star_1", "merged"},
                {}};
    SvgDrawing drawing{.title = "Pairs of triangles, their circumcenters and dual edges"};
    for (const auto& pair : pairs) {
        const auto mesh = discretized(mesh_of(pair));
        draw(drawing, pair, mesh);
        // a center on the edge counts as crossing
        const bool crosses = pair.upper * pair.lower >= 0;
        const double dual = mesh.input_geometry().volumes().dual(1)[common_edge];
        const bool zero = std::abs(dual) < 1e-12;
        table.rows.push_back(
            {pair.label, crosses ? "crosses the edge" : "on one side", kind(mesh), zero ? 0 : dual,
             zero ? 0 : star(mesh.input_geometry().volumes(), 1).diagonal()[common_edge],
             mesh.complex().size(2) == 1 ? "yes" : "no"});
    }
    tell_lines(drawing,
               {{{.stroke = black, .fill = face_color, .width = 1.6}, "triangles"},
                {{.stroke = positive_color, .width = 3}, "dual edge of positive length"},
                {{.stroke = negative_color, .width = 3}, "dual edge of negative length"},
                {{.width = 1.6, .dashes = {6, 4}},
                 "common edge that is merged away; its dual edge "
                 "is black, of length 0"},
                {{.stroke = gray, .width = 0.8, .dashes = {2, 3}}, "circumcircles"}},
               {-1.3, -6.2}, 11 / 688.0);
    return {
        .name = "fig2",
        .title = "Kinds of pairs of triangles (Fig. 2)",
        .tables = {std::move(table)},
        .drawings = {{"fig2", std::move(drawing)}},
        .remarks = {"Arrows run from the lower triangle's circumcenter to the upper one's: blue "
                    "where the dual edge is positive, red where it is flipped. Dashed edges are "
                    "those that merging removes."}};
}

} // namespace polydec::paper
