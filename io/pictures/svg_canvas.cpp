// SPDX-License-Identifier: MIT
#include "io/pictures/svg_canvas.h"

#include "io/base64.h"
#include "io/xml_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

namespace polydec {

namespace {

/// Hundredths of a pixel suffice, and no zeros behind them.
std::string pixels(double value) {
    std::string text = fmt::format("{:.2f}", value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.')
        text.pop_back();
    return text == "-0" ? "0" : text;
}

std::string list(const std::vector<SvgPoint>& points) {
    std::string text;
    for (const auto& [x, y] : points)
        text += fmt::format("{}{},{}", text.empty() ? "" : " ", pixels(x), pixels(y));
    return text;
}

std::string attributes(const SvgStyle& style) {
    std::string text = fmt::format("fill=\"{}\" stroke=\"{}\"", xml_escaped(style.fill),
                                   xml_escaped(style.stroke));
    if (style.opacity != 1 && style.fill != "none")
        text += fmt::format(" fill-opacity=\"{}\"", pixels(style.opacity));
    if (style.stroke == "none")
        return text;
    text += fmt::format(" stroke-width=\"{}\"", pixels(style.width));
    std::string dashes;
    for (const double dash : style.dashes)
        dashes += (dashes.empty() ? "" : " ") + pixels(dash);
    if (!dashes.empty())
        text += fmt::format(" stroke-dasharray=\"{}\"", dashes);
    return text;
}

const char* name(SvgAnchor anchor) {
    return anchor == SvgAnchor::start ? "start" : anchor == SvgAnchor::middle ? "middle" : "end";
}

/// Draws shapes in pixels.
struct Painter {
    SvgCanvas& canvas;

    void operator()(const SvgPolyline& line) const { canvas.polyline(line.points, line.style); }
    void operator()(const SvgPolygon& polygon) const {
        canvas.polygon(polygon.points, polygon.style);
    }
    void operator()(const SvgCircle& circle) const {
        canvas.circle(circle.center, circle.radius, circle.style);
    }
    void operator()(const SvgDot& dot) const { canvas.circle(dot.center, dot.radius, dot.style); }
    void operator()(const SvgText& text) const {
        canvas.text(text.at, text.text,
                    {.size = text.size, .anchor = text.anchor, .color = text.color});
    }

    /// The head is a triangle as long as a few widths of the line, but not longer than the arrow.
    void operator()(const SvgArrow& arrow) const {
        const auto& [a, b, style] = arrow;
        const double dx = b[0] - a[0], dy = b[1] - a[1], length = std::hypot(dx, dy);
        if (length == 0)
            return;
        const double head = std::min(length, 4 + 3 * style.width), half = 0.4 * head;
        const double ux = dx / length, uy = dy / length;
        const SvgPoint base{b[0] - head * ux, b[1] - head * uy};
        canvas.polyline({a, base}, style);
        SvgStyle solid = style;
        solid.fill = solid.stroke;
        solid.dashes.clear();
        solid.stroke = "none";
        canvas.polygon({b,
                        {base[0] - half * uy, base[1] + half * ux},
                        {base[0] + half * uy, base[1] - half * ux}},
                       solid);
    }
};

} // namespace

SvgCanvas::SvgCanvas(double width, double height)
    : text_(fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" "
                        "viewBox=\"0 0 {0} {1}\" font-family=\"Helvetica, Arial, 'DejaVu Sans', "
                        "sans-serif\" stroke-linejoin=\"round\">\n"
                        "<rect width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n",
                        pixels(width), pixels(height))) {}

void SvgCanvas::polyline(const std::vector<SvgPoint>& points, const SvgStyle& style) {
    text_ += fmt::format("<polyline points=\"{}\" {}/>\n", list(points), attributes(style));
}

void SvgCanvas::polygon(const std::vector<SvgPoint>& points, const SvgStyle& style) {
    text_ += fmt::format("<polygon points=\"{}\" {}/>\n", list(points), attributes(style));
}

void SvgCanvas::circle(SvgPoint center, double radius, const SvgStyle& style) {
    text_ += fmt::format("<circle cx=\"{}\" cy=\"{}\" r=\"{}\" {}/>\n", pixels(center[0]),
                         pixels(center[1]), pixels(radius), attributes(style));
}

void SvgCanvas::image(SvgPoint left_top, double width, double height, std::string_view png) {
    text_ += fmt::format("<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" "
                         "href=\"data:image/png;base64,{}\"/>\n",
                         pixels(left_top[0]), pixels(left_top[1]), pixels(width), pixels(height),
                         base64_text(png));
}

void SvgCanvas::text(SvgPoint at, std::string_view text, const SvgLabel& label) {
    text_ += fmt::format("<text x=\"{0}\" y=\"{1}\" font-size=\"{2}\" text-anchor=\"{3}\" "
                         "fill=\"{4}\"",
                         pixels(at[0]), pixels(at[1]), pixels(label.size), name(label.anchor),
                         xml_escaped(label.color));
    if (label.turned != 0)
        text_ += fmt::format(" transform=\"rotate({} {} {})\"", pixels(label.turned), pixels(at[0]),
                             pixels(at[1]));
    text_ += fmt::format(">{}", xml_escaped(text));
    if (label.exponent)
        text_ += fmt::format("<tspan dy=\"{}\" font-size=\"{}\">{}</tspan>",
                             pixels(-0.4 * label.size), pixels(0.75 * label.size), *label.exponent);
    text_ += "</text>\n";
}

void SvgCanvas::draw(const SvgShape& shape) {
    std::visit(Painter{*this}, shape);
}

void SvgCanvas::open_group(std::string_view name) {
    text_ += fmt::format("<g><title>{}</title>\n", xml_escaped(name));
}

void SvgCanvas::close_group() {
    text_ += "</g>\n";
}

std::string SvgCanvas::finish() {
    return std::move(text_) + "</svg>\n";
}

double svg_text_width(std::string_view text, double size) {
    const auto characters = std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; // no byte inside a character
    });
    return 0.58 * size * static_cast<double>(characters);
}

std::string svg_shortened(const std::string& text, double size, double most) {
    std::string result = text;
    while (!result.empty() && svg_text_width(result, size) > most) {
        result = text.substr(0, result.size() - 1);
        while (!result.empty() &&
               (static_cast<unsigned char>(text[result.size()]) & 0xC0U) == 0x80U)
            result.pop_back(); // inside a character
        if (svg_text_width(result + "...", size) <= most)
            return result + "...";
    }
    return result;
}

} // namespace polydec
