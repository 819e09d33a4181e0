// SPDX-License-Identifier: MIT
#include "base/checks.h"
#include "base/errors.h"
#include "io/pictures/draw_structure.h"
#include "io/pictures/structure_style.h"
#include "io/pictures/svg_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace polydec {

namespace {

/// The cells' numbers on the middle of their nearest faces that nothing hides.
std::map<Index, SvgPoint> seen_faces(const SvgDrawing& drawing, const std::vector<Index>& cells) {
    std::map<Index, SvgPoint> result;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const auto& points = std::get<SvgPolygon>(drawing.shapes[i]).points;
        SvgPoint middle{0, 0};
        for (const auto& [x, y] : points)
            middle = {middle[0] + x / static_cast<double>(points.size()),
                      middle[1] + y / static_cast<double>(points.size())};
        const bool hidden = std::any_of(
            drawing.shapes.begin() + i + 1, drawing.shapes.end(), [&](const SvgShape& nearer) {
                return covers(std::get<SvgPolygon>(nearer).points, middle);
            });
        if (!hidden)
            result[cells[i]] = middle;
    }
    return result;
}

void add_numbers(SvgDrawing& drawing, const std::vector<Index>& cells, bool words) {
    constexpr double size = 14, height = 1.3 * size;
    const SvgExtent extent = extent_of_polygons(drawing);
    const double pixel =
        std::max(extent.size(0), extent.size(1) / 2) / (drawing.width - 2 * drawing.margin);
    SvgObstacles taken;
    for (auto [cell, middle] : seen_faces(drawing, cells)) {
        const std::string text = std::to_string(cell);
        const double width = std::max(height, svg_text_width(text, size) + 1);
        const SvgPoint place = free_center({middle}, width * pixel, height * pixel, taken);
        taken.push_back(box_around(place, width * pixel, height * pixel));
        drawing.shapes.emplace_back(SvgText{{place[0], place[1] - 0.35 * size * pixel},
                                            text,
                                            size,
                                            SvgAnchor::middle,
                                            number_colors[3]});
    }
    if (words)
        tell_lines(drawing, {{{.stroke = "none"}, "numbers of cells (green)"}}, extent.low, pixel);
}

SvgDrawing draw_apart(const Discretization& mesh, const LessonOptions& options) {
    const StructureOptions& structure = options.structure;
    if (structure.duals || structure.dual_orientations || structure.centroids || structure.cell ||
        structure.orientations || structure.circumcircles || options.both_duals)
        throw InvalidInput("a drawing of a solid shows its cells and their numbers: leave out "
                           "duals, orientations and circumcircles, or draw a surface");
    const auto all = [](const Vector&) { return true; };
    const SolidFaces faces = options.explode > 0
                                 ? kept_cells(mesh, all, options.explode / (1 + options.explode))
                                 : kept_faces(mesh, all);
    SvgDrawing drawing = draw_solid(faces, structure.view);
    drawing.margin = 24;
    if (structure.numbers) {
        std::vector<Index> cells;
        for (const Index face : painting_order(faces, structure.view))
            cells.push_back(faces.cells[face]);
        add_numbers(drawing, cells, structure.words);
    }
    return drawing;
}

/// The dual of the mesh beside the barycentric one.
std::vector<SvgDrawing> draw_both(const Discretization& mesh, StructureOptions options) {
    options.duals = true;
    const std::string before =
        options.view.title.empty() ? "" : fmt::format("{}: ", options.view.title);
    options.view.title =
        before + (mesh.options().centers.are_circumcenters() ? "circumcentric dual" : "dual");
    std::vector<SvgDrawing> drawings{draw_structure(mesh, options)};
    options.centroids = true;
    options.view.title = before + "barycentric dual";
    drawings.push_back(draw_structure(mesh, options));
    return drawings;
}

} // namespace

SvgDrawing draw_lesson(const Discretization& mesh, const LessonOptions& options) {
    check_not_negative("how far cells move apart", options.explode);
    if (options.explode > 0 && mesh.dimension() != 3)
        throw InvalidInput(fmt::format("only the cells of a solid move apart, and this mesh has "
                                       "dimension {}: leave 'explode' out",
                                       mesh.dimension()));
    std::vector<SvgDrawing> drawings;
    if (mesh.dimension() == 3)
        drawings = {draw_apart(mesh, options)};
    else if (options.both_duals)
        drawings = draw_both(mesh, options.structure);
    else
        drawings = {draw_structure(mesh, options.structure)};
    if (options.matrix)
        drawings.push_back(draw_boundary(mesh.complex(), *options.matrix));
    return drawings.size() == 1 ? std::move(drawings.front()) : side_by_side(drawings);
}

} // namespace polydec
