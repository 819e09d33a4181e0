// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"
#include "io/pictures/svg_drawing.h"

namespace polydec::paper {

/// Colors of the drawings: Okabe and Ito's palette, safe for color-blind readers.
constexpr const char* black = "#000000";
constexpr const char* gray = "#8a8a8a";
constexpr const char* positive_color = "#0072B2";
constexpr const char* negative_color = "#D55E00";
constexpr const char* face_color = "#f1efe6";

/// A translated point of the plane.
inline SvgPoint place(const Points& points, Index row, const SvgPoint& shift) {
    return {points(row, 0) + shift[0], points(row, 1) + shift[1]};
}

} // namespace polydec::paper
