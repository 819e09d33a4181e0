// SPDX-License-Identifier: MIT
#include "io/pictures/svg_drawing.h"

#include "base/errors.h"
#include "io/pictures/svg_canvas.h"
#include "io/pictures/svg_layout.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace polydec {

namespace {

constexpr double title_size = 18;
constexpr double title_height = 34;

/// Calls `take` with each point of a shape.
template <class Shape, class Take>
void for_points(Shape& shape, Take take) {
    if constexpr (requires { shape.points; }) {
        std::for_each(shape.points.begin(), shape.points.end(), take);
    } else if constexpr (requires { shape.center; }) {
        take(shape.center);
    } else if constexpr (requires { shape.from; }) {
        take(shape.from);
        take(shape.to);
    } else {
        take(shape.at);
    }
}

SvgExtent extent_of(const SvgDrawing& drawing) {
    if (drawing.shapes.empty())
        throw InvalidInput("the drawing has no shapes: add one");
    SvgExtent extent;
    for (std::size_t i = 0; i < drawing.shapes.size(); ++i) {
        const auto* const circle = std::get_if<SvgCircle>(&drawing.shapes[i]);
        const double around = circle == nullptr ? 0 : std::abs(circle->radius);
        bool has_points = false;
        const auto add = [&](const SvgPoint& point) {
            for (const double coordinate : point)
                if (!std::isfinite(coordinate - around) || !std::isfinite(coordinate + around))
                    throw InvalidInput(fmt::format("shape {} of the drawing has a coordinate or "
                                                   "radius that is NaN or infinite: correct it",
                                                   i));
            extent.add(point, around);
            has_points = true;
        };
        std::visit([&](const auto& shape) { for_points(shape, add); }, drawing.shapes[i]);
        if (!has_points)
            throw InvalidInput(
                fmt::format("shape {} of the drawing has no points: leave it out", i));
    }
    if (!(std::max(extent.size(0), extent.size(1)) > 0))
        throw InvalidInput("all shapes of the drawing lie at one point: there is nothing to scale");
    return extent;
}

/// From world coordinates to pixels.
struct View {
    double scale, left, top;
    SvgExtent extent;

    SvgPoint operator()(const SvgPoint& p) const {
        return {left + scale * (p[0] - extent.low[0]), top + scale * (extent.high[1] - p[1])};
    }
};

/// A shape with its points where they go, and a circle that is larger by a factor.
template <class Move>
SvgShape moved(SvgShape shape, double factor, Move move) {
    std::visit([&](auto& own) { for_points(own, [&](SvgPoint& p) { p = move(p); }); }, shape);
    if (auto* const circle = std::get_if<SvgCircle>(&shape))
        circle->radius *= factor;
    return shape;
}

/// Where a drawing's shapes are in pixels, y down. What is much higher than wide stands in the
/// middle instead of making a tower.
View view_of(const SvgDrawing& drawing) {
    const SvgExtent extent = extent_of(drawing);
    const double inside = drawing.width - 2 * drawing.margin;
    if (!(inside > 0))
        throw InvalidInput(fmt::format("a drawing {} pixels wide has no room between margins of {}",
                                       drawing.width, drawing.margin));
    const double across = std::max(extent.size(0), extent.size(1) / 2);
    const double scale = inside / across;
    return {scale, drawing.margin + 0.5 * scale * (across - extent.size(0)),
            drawing.margin + (drawing.title.empty() ? 0 : title_height), extent};
}

} // namespace

std::string to_svg(const SvgDrawing& drawing) {
    const View view = view_of(drawing);
    SvgCanvas canvas(drawing.width, drawing.margin + view.top + view.scale * view.extent.size(1));
    if (!drawing.title.empty())
        canvas.text({drawing.width / 2, drawing.margin + title_size - 4}, drawing.title,
                    {.size = title_size});
    for (const auto& shape : drawing.shapes)
        canvas.draw(moved(shape, view.scale, view));
    return canvas.finish();
}

SvgDrawing side_by_side(const std::vector<SvgDrawing>& drawings) {
    if (drawings.empty())
        throw InvalidInput("there are no drawings to arrange side by side: give at least one");
    SvgDrawing row{.width = 0, .margin = 0};
    std::vector<View> views;
    double above = 0; // the middle
    for (const auto& drawing : drawings) {
        views.push_back(view_of(drawing));
        above = std::max(above, views.back().scale * views.back().extent.size(1) / 2);
        row.margin = std::max(row.margin, drawing.margin);
    }
    double x = 0;
    for (std::size_t i = 0; i < drawings.size(); ++i) {
        const auto& [title, shapes, width, margin] = drawings[i];
        if (!title.empty())
            row.shapes.emplace_back(SvgText{{x + width / 2, above + margin}, title, title_size});
        const View& view = views[i];
        const double middle = view.top + view.scale * view.extent.size(1) / 2;
        for (const auto& shape : shapes) // in a world of pixels, y up
            row.shapes.push_back(moved(shape, view.scale, [&](const SvgPoint& point) {
                const auto [left, top] = view(point);
                return SvgPoint{x + left, middle - top};
            }));
        x += width;
    }
    row.width = extent_of(row).size(0) + 2 * row.margin;
    return row;
}

} // namespace polydec
