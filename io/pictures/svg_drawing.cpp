// SPDX-License-Identifier: MIT
#include "io/pictures/svg_drawing.h"

#include "base/errors.h"
#include "io/pictures/svg_canvas.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace polydec {

namespace {

constexpr double title_size = 18;
constexpr double title_height = 34;

/// The points that count in the extent of a drawing; a circle's are the corners around it.
struct PointsOf {
    std::vector<SvgPoint> operator()(const SvgPolyline& line) const { return line.points; }
    std::vector<SvgPoint> operator()(const SvgPolygon& polygon) const { return polygon.points; }
    std::vector<SvgPoint> operator()(const SvgCircle& circle) const {
        const auto [x, y] = circle.center;
        const double r = circle.radius;
        return {{x - r, y - r}, {x + r, y + r}};
    }
    std::vector<SvgPoint> operator()(const SvgDot& dot) const { return {dot.center}; }
    std::vector<SvgPoint> operator()(const SvgArrow& arrow) const { return {arrow.from, arrow.to}; }
    std::vector<SvgPoint> operator()(const SvgText& text) const { return {text.at}; }
};

struct Extent {
    SvgPoint low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    SvgPoint high{-low[0], -low[1]};

    double size(int axis) const { return high[axis] - low[axis]; }
};

Extent extent_of(const SvgDrawing& drawing) {
    if (drawing.shapes.empty())
        throw InvalidInput("the drawing has no shapes: add one");
    Extent extent;
    for (std::size_t i = 0; i < drawing.shapes.size(); ++i) {
        const auto points = std::visit(PointsOf{}, drawing.shapes[i]);
        if (points.empty())
            throw InvalidInput(
                fmt::format("shape {} of the drawing has no points: leave it out", i));
        for (const auto& point : points)
            for (int axis = 0; axis < 2; ++axis) {
                if (!std::isfinite(point[axis]))
                    throw InvalidInput(fmt::format("shape {} of the drawing has a coordinate or "
                                                   "radius that is NaN or infinite: correct it",
                                                   i));
                extent.low[axis] = std::min(extent.low[axis], point[axis]);
                extent.high[axis] = std::max(extent.high[axis], point[axis]);
            }
    }
    if (!(std::max(extent.size(0), extent.size(1)) > 0))
        throw InvalidInput("all shapes of the drawing lie at one point: there is nothing to scale");
    return extent;
}

/// From world coordinates to pixels.
struct View {
    double scale, left, top;
    Extent extent;

    SvgPoint operator()(const SvgPoint& p) const {
        return {left + scale * (p[0] - extent.low[0]), top + scale * (extent.high[1] - p[1])};
    }
    std::vector<SvgPoint> operator()(std::vector<SvgPoint> points) const {
        for (auto& point : points)
            point = (*this)(point);
        return points;
    }
};

class Painter {
public:
    Painter(SvgCanvas& canvas, const View& view) : canvas_(canvas), view_(view) {}

    void operator()(const SvgPolyline& line) const {
        canvas_.polyline(view_(line.points), line.style);
    }
    void operator()(const SvgPolygon& polygon) const {
        canvas_.polygon(view_(polygon.points), polygon.style);
    }
    void operator()(const SvgCircle& circle) const {
        canvas_.circle(view_(circle.center), view_.scale * circle.radius, circle.style);
    }
    void operator()(const SvgDot& dot) const {
        canvas_.circle(view_(dot.center), dot.radius, dot.style);
    }
    void operator()(const SvgText& text) const {
        canvas_.text(view_(text.at), text.text,
                     {.size = text.size, .anchor = text.anchor, .color = text.color});
    }

    /// The head is a triangle as long as a few widths of the line, but not longer than the arrow.
    void operator()(const SvgArrow& arrow) const {
        const SvgPoint a = view_(arrow.from), b = view_(arrow.to);
        const double dx = b[0] - a[0], dy = b[1] - a[1], length = std::hypot(dx, dy);
        if (length == 0)
            return;
        const double head = std::min(length, 4 + 3 * arrow.style.width), half = 0.4 * head;
        const double ux = dx / length, uy = dy / length;
        const SvgPoint base{b[0] - head * ux, b[1] - head * uy};
        canvas_.polyline({a, base}, arrow.style);
        SvgStyle solid = arrow.style;
        solid.fill = solid.stroke;
        solid.dashes.clear();
        solid.stroke = "none";
        canvas_.polygon({b,
                         {base[0] - half * uy, base[1] + half * ux},
                         {base[0] + half * uy, base[1] - half * ux}},
                        solid);
    }

private:
    SvgCanvas& canvas_;
    const View& view_;
};

/// Where a drawing's shapes are in pixels, y down. What is much higher than wide stands in the
/// middle instead of making a tower.
View view_of(const SvgDrawing& drawing) {
    const Extent extent = extent_of(drawing);
    const double inside = drawing.width - 2 * drawing.margin;
    if (!(inside > 0))
        throw InvalidInput(fmt::format("a drawing {} pixels wide has no room between margins of {}",
                                       drawing.width, drawing.margin));
    const double across = std::max(extent.size(0), extent.size(1) / 2);
    const double scale = inside / across;
    return {scale, drawing.margin + 0.5 * scale * (across - extent.size(0)),
            drawing.margin + (drawing.title.empty() ? 0 : title_height), extent};
}

/// Shapes whose world are pixels of another drawing.
struct Moved {
    const View& view;
    double x, y; ///< where the left upper corner goes, y up

    SvgPoint operator()(const SvgPoint& point) const {
        const auto [left, top] = view(point);
        return {x + left, y - top};
    }
    std::vector<SvgPoint> operator()(std::vector<SvgPoint> points) const {
        for (auto& point : points)
            point = (*this)(point);
        return points;
    }
    SvgShape operator()(const SvgPolyline& line) const {
        return SvgPolyline{(*this)(line.points), line.style};
    }
    SvgShape operator()(const SvgPolygon& polygon) const {
        return SvgPolygon{(*this)(polygon.points), polygon.style};
    }
    SvgShape operator()(const SvgCircle& circle) const {
        return SvgCircle{(*this)(circle.center), view.scale * circle.radius, circle.style};
    }
    SvgShape operator()(SvgDot dot) const {
        dot.center = (*this)(dot.center);
        return dot;
    }
    SvgShape operator()(const SvgArrow& arrow) const {
        return SvgArrow{(*this)(arrow.from), (*this)(arrow.to), arrow.style};
    }
    SvgShape operator()(SvgText text) const {
        text.at = (*this)(text.at);
        return text;
    }
};

} // namespace

std::string to_svg(const SvgDrawing& drawing) {
    const View view = view_of(drawing);
    SvgCanvas canvas(drawing.width, drawing.margin + view.top + view.scale * view.extent.size(1));
    if (!drawing.title.empty())
        canvas.text({drawing.width / 2, drawing.margin + title_size - 4}, drawing.title,
                    {.size = title_size});
    for (const auto& shape : drawing.shapes)
        std::visit(Painter(canvas, view), shape);
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
        const Moved moved{views[i], x, views[i].top + views[i].scale * views[i].extent.size(1) / 2};
        for (const auto& shape : shapes)
            row.shapes.push_back(std::visit(moved, shape));
        x += width;
    }
    row.width = extent_of(row).size(0) + 2 * row.margin;
    return row;
}

} // namespace polydec
