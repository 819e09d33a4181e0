// SPDX-License-Identifier: MIT
#pragma once

#include "io/pages/page.h"

#include <functional>
#include <string>

namespace polydec {

/// A still picture of a page as it opens, without a browser: the surface with its field, a bar of
/// colors with their values, the title and the time. It has the page's camera and colors. Cells of
/// a 1-form that has arrows show the length of its vectors, with the arrows. Edges are drawn up to
/// 2000 cells. Throws InvalidInput like to_html, and without lines or faces.
std::string to_png(const Page& page);

struct PageContent;

/// What a page carries for browsers without WebGL, and for albums. Throws like to_png.
struct StillView {
    std::string png;       ///< that of to_png
    std::string thumbnail; ///< PNG, an eighth of the size, without text
    std::string words;     ///< a sentence in English: what colors and arrows show
};
StillView still_view(const PageContent& content);

/// The same as to_png, as SVG: up to 4000 triangles as polygons, painted from far to near; above,
/// it contains the PNG picture of the surface.
std::string to_svg(const Page& page);

/// The PNG pictures of all steps, one after the other, in colors of one range.
void draw_steps(const Page& page, const std::function<void(const std::string& png)>& take);

} // namespace polydec
