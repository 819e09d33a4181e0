// SPDX-License-Identifier: MIT
#include "io/pages/picture_overlay.h"

namespace polydec {

void add_arrow(PictureOverlay& overlay, SvgPoint from, SvgPoint to, double width, Color color) {
    const double x = to[0] - from[0], y = to[1] - from[1], head = 0.32;
    const auto barb = [&](double side) {
        return SvgPoint{to[0] - head * (x + side * y), to[1] - head * (y - side * x)};
    };
    overlay.strokes.push_back({{from, to}, width, color});
    overlay.strokes.push_back({{barb(0.7), to, barb(-0.7)}, width, color});
}

std::string shortened(const std::string& text, double size, double most) {
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

void draw(Raster& raster, const PictureOverlay& overlay) {
    for (const auto& [points, width, color] : overlay.strokes)
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            raster.stroke(points[i], points[i + 1], width, color);
    for (const auto& [box, color] : overlay.boxes)
        raster.fill(box, color);
    for (const auto& [at, text, size, anchor, color] : overlay.labels)
        raster.text(at, text, size, anchor, color);
}

void draw(SvgCanvas& canvas, const PictureOverlay& overlay) {
    for (const auto& [points, width, color] : overlay.strokes)
        canvas.polyline(points, {.stroke = color_text(color), .width = width});
    for (const auto& [box, color] : overlay.boxes)
        canvas.polygon({{box.left, box.top},
                        {box.right, box.top},
                        {box.right, box.bottom},
                        {box.left, box.bottom}},
                       {.stroke = "none", .fill = color_text(color)});
    for (const auto& [at, text, size, anchor, color] : overlay.labels)
        canvas.text(at, text, {.size = size, .anchor = anchor, .color = color_text(color)});
}

} // namespace polydec
