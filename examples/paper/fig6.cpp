// SPDX-License-Identifier: MIT
//
// Fig. 6: the four kinds of meshes for the Poisson problem, with the circumcentric duals of their
// merged cells.
#include "examples/paper/pictures.h"
#include "examples/paper/problems.h"
#include "examples/paper/reproductions.h"
#include "io/pictures/structure_style.h"

namespace polydec::paper {

namespace {

using Row = IncidenceMatrix::InnerIterator;

void draw_edges(SvgDrawing& drawing, const Discretization& mesh, const SvgPoint& shift) {
    const auto& K = mesh.input();
    for (Index e = 0; e < K.size(1); ++e) {
        const bool removed = mesh.merging().carriers(1)[e].dimension == 2;
        SvgStyle style{.stroke = removed ? gray : black, .width = removed ? 0.9 : 1.1};
        if (removed)
            style.dashes = {4, 3};
        drawing.shapes.push_back(SvgPolyline{{place(mesh.points(), K.simplices(1)(e, 0), shift),
                                              place(mesh.points(), K.simplices(1)(e, 1), shift)},
                                             style});
    }
}

/// Dual edges: between circumcenters, or from a circumcenter to the midpoint of a boundary edge.
void draw_duals(SvgDrawing& drawing, const Discretization& mesh, const SvgPoint& shift) {
    const Points centers = cell_centers(mesh, 2);
    const Points middles = cell_centers(mesh, 1);
    const auto& P = mesh.complex();
    const IncidenceMatrix faces = P.boundary(2); // row e: the faces at edge e
    for (Index e = 0; e < P.size(1); ++e) {
        std::vector<SvgPoint> ends;
        for (Row face(faces, e); face; ++face)
            ends.push_back(place(centers, static_cast<Index>(face.col()), shift));
        if (ends.size() == 1)
            ends.push_back(place(middles, e, shift));
        const bool flipped = mesh.volumes().dual(1)[e] < -1e-12;
        drawing.shapes.push_back(
            SvgPolyline{ends, {.stroke = flipped ? negative_color : positive_color, .width = 1.3}});
    }
    for (Index face = 0; face < P.size(2); ++face)
        drawing.shapes.push_back(
            SvgDot{place(centers, face, shift), 1.8, {.stroke = "none", .fill = positive_color}});
}

std::vector<Entry> row_of(const std::string& name, const Discretization& mesh) {
    const auto kinds = facet_kinds(mesh.input_geometry(), mesh.options());
    std::vector<Entry> row{name};
    for (int k = 0; k <= 2; ++k)
        row.emplace_back(long{mesh.input().size(k)});
    for (int k = 1; k <= 2; ++k)
        row.emplace_back(long{mesh.complex().size(k)});
    for (const Index count :
         {kinds.well_centered, kinds.delaunay, kinds.non_delaunay, kinds.cospherical})
        row.emplace_back(long{count});
    return row;
}

} // namespace

Report fig6(const Request&) {
    Table table{"meshes",
                "cells and pairs of neighbors",
                {"mesh", "vertices", "edges", "triangles", "merged edges", "merged faces",
                 "well-centered", "Delaunay", "non-Delaunay", "concyclic"},
                {}};
    SvgDrawing drawing{.title = "Meshes and their circumcentric duals", .width = 900};
    const double apart = 1.12, below = 1.2;
    for (const auto& family : planar_families()) {
        const auto mesh = discretized(family.make(0));
        const auto i = table.rows.size();
        const SvgPoint shift{apart * static_cast<double>(i % 2),
                             -below * static_cast<double>(i / 2)};
        draw_edges(drawing, mesh, shift);
        draw_duals(drawing, mesh, shift);
        drawing.shapes.push_back(SvgText{{shift[0] + 0.5, shift[1] - 0.1}, family.name, 17});
        table.rows.push_back(row_of(family.name, mesh));
    }
    tell_lines(drawing,
               {{{.stroke = black, .width = 1.1}, "edges of the cells"},
                {{.stroke = gray, .width = 0.9, .dashes = {4, 3}}, "edges merged away"},
                {{.stroke = positive_color, .width = 1.3}, "dual edges, dots: circumcenters"},
                {{.stroke = negative_color, .width = 1.3}, "dual edges of negative length"}},
               {0, -below - 0.15}, (1 + apart) / 868);
    return {.name = "fig6",
            .title = "Meshes of the Poisson problem (Fig. 6)",
            .tables = {std::move(table)},
            .drawings = {{"fig6", std::move(drawing)}},
            .remarks = {"Edges that merging removes are dashed. Dual edges are blue, and red where "
                        "they are flipped."}};
}

} // namespace polydec::paper
