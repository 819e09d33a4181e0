// SPDX-License-Identifier: MIT
#pragma once

#include "io/pictures/raster.h"
#include "io/pictures/svg_canvas.h"

#include <string>
#include <vector>

namespace polydec {

/// What lies over a picture, in pixels, y down: the same for both kinds of files.
struct PictureOverlay {
    struct Stroke {
        std::vector<SvgPoint> points;
        double width;
        Color color;
    };
    struct Box {
        SvgBox box;
        Color color;
    };
    struct Label {
        SvgPoint at;
        std::string text;
        double size;
        SvgAnchor anchor;
        Color color;
    };
    std::vector<Stroke> strokes = {};
    std::vector<Box> boxes = {};
    std::vector<Label> labels = {};
};

/// A line with two short ones at its end.
void add_arrow(PictureOverlay& overlay, SvgPoint from, SvgPoint to, double width, Color color);

/// The text, without its end if it is longer than this many pixels.
std::string shortened(const std::string& text, double size, double most);

void draw(Raster& raster, const PictureOverlay& overlay);
void draw(SvgCanvas& canvas, const PictureOverlay& overlay);

} // namespace polydec
