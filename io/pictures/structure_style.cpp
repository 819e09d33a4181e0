// SPDX-License-Identifier: MIT
#include "io/pictures/structure_style.h"

namespace polydec {

namespace {

constexpr double words_size = 13, words_row = 1.7 * words_size,
                 words_gap = 0.5 * words_size; // pixels

} // namespace

double height_of_lines(std::size_t rows) {
    return words_gap + words_row * static_cast<double>(rows);
}

void tell_lines(SvgDrawing& drawing, const std::vector<LineInWords>& lines, SvgPoint corner,
                double pixel) {
    const double x = corner[0];
    double y = corner[1] - words_gap * pixel;
    for (const auto& [style, words] : lines) {
        y -= words_row * pixel;
        const double middle = y + 0.35 * words_size * pixel, half = 0.4 * words_size * pixel;
        if (style.fill == "none")
            drawing.shapes.emplace_back(
                SvgPolyline{{{x, middle}, {x + 28 * pixel, middle}}, style});
        else
            drawing.shapes.emplace_back(SvgPolygon{{{x, middle - half},
                                                    {x + 28 * pixel, middle - half},
                                                    {x + 28 * pixel, middle + half},
                                                    {x, middle + half}},
                                                   style});
        drawing.shapes.emplace_back(
            SvgText{{x + 36 * pixel, y}, words, words_size, SvgAnchor::start, "#000000"});
    }
}

} // namespace polydec
