// SPDX-License-Identifier: MIT
#include "io/pictures/structure_style.h"

namespace polydec {

void tell_lines(SvgDrawing& drawing, const std::vector<LineInWords>& lines, SvgPoint corner,
                double pixel) {
    constexpr double size = 13, row_height = 1.7 * size; // pixels
    const double x = corner[0];
    double y = corner[1] - 0.5 * size * pixel;
    for (const auto& [style, words] : lines) {
        y -= row_height * pixel;
        const double middle = y + 0.35 * size * pixel;
        drawing.shapes.emplace_back(SvgPolyline{{{x, middle}, {x + 28 * pixel, middle}}, style});
        drawing.shapes.emplace_back(
            SvgText{{x + 36 * pixel, y}, words, size, SvgAnchor::start, "#000000"});
    }
}

} // namespace polydec
