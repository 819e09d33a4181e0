// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "io/pictures/draw_structure.h"
#include "io/pictures/structure_style.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace polydec {

namespace {

constexpr Index most_lines = 60; // rows or columns
constexpr double entry_size = 13, line_height = 22;
constexpr std::array color_names{"black", "orange", "purple", "green"};

const char* degree_in_words(int k, int n) {
    constexpr std::array names{"vertices", "edges", "faces"};
    return k == n && n > 1 ? "cells" : names[k];
}

SvgText entry_text(SvgPoint at, Index value, const char* color) {
    at[1] -= 0.35 * entry_size;
    const std::string sign = value < 0 ? "\u2212" : "";
    return {at, sign + std::to_string(std::abs(value)), entry_size, SvgAnchor::middle, color};
}

} // namespace

SvgDrawing draw_boundary(const CellComplex& complex, int k) {
    const int n = complex.dimension();
    if (k < 1 || k > n || n > 3)
        throw InvalidInput(fmt::format("the boundary matrix of {}-cells in a complex of dimension "
                                       "{}: expected a degree from 1 to the dimension, at most 3",
                                       k, n));
    const Index rows = complex.size(k - 1), columns = complex.size(k);
    if (std::max(rows, columns) > most_lines)
        throw InvalidInput(fmt::format("the boundary matrix has {} rows and {} columns: a drawing "
                                       "shows at most {}; choose a smaller mesh",
                                       rows, columns, most_lines));
    // one unit is a pixel
    const double pitch = std::clamp(200.0 / (columns + 1), 26.0, 60.0);
    const double right = pitch * (columns + 0.6), bottom = -line_height * (rows + 0.6);
    const SvgStyle line{.stroke = "#9AA7B5"};
    SvgDrawing drawing{.margin = 24};
    drawing.shapes = {
        SvgPolyline{{{-pitch / 2, -line_height / 2}, {right, -line_height / 2}}, line},
        SvgPolyline{{{pitch / 2, line_height / 2}, {pitch / 2, bottom}}, line}};
    for (Index i = 0; i < rows; ++i)
        drawing.shapes.emplace_back(
            entry_text({0, -line_height * (i + 1)}, i, number_colors[k - 1]));
    for (Index j = 0; j < columns; ++j)
        drawing.shapes.emplace_back(entry_text({pitch * (j + 1), 0}, j, number_colors[k]));
    const DenseMatrix entries = complex.boundary(k).toDense().cast<double>();
    for (Index i = 0; i < rows; ++i)
        for (Index j = 0; j < columns; ++j) {
            const auto entry = static_cast<Index>(entries(i, j));
            drawing.shapes.emplace_back(entry_text({pitch * (j + 1), -line_height * (i + 1)}, entry,
                                                   entry == 0 ? "#B8C0CA" : "#000000"));
        }
    const auto tell = [&](double y, const std::string& words, double text_size) {
        drawing.shapes.emplace_back(SvgText{{-pitch / 2, y}, words, text_size, SvgAnchor::start});
    };
    const double top = 1.3 * line_height, below = bottom - 2 * line_height;
    tell(top, fmt::format("boundary of the {}", degree_in_words(k, n)), 16);
    tell(below + line_height,
         fmt::format("rows: {} ({})", degree_in_words(k - 1, n), color_names[k - 1]), entry_size);
    tell(below, fmt::format("columns: {} ({})", degree_in_words(k, n), color_names[k]), entry_size);
    drawing.width = std::max(right + pitch / 2, (top - below) / 2) + 2 * drawing.margin;
    return drawing;
}

} // namespace polydec
