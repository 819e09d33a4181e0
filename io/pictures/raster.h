// SPDX-License-Identifier: MIT
#pragma once

#include "io/pictures/color_map.h"
#include "io/pictures/svg_layout.h"

#include <string>
#include <string_view>
#include <vector>

namespace polydec {

/// An image of opaque pixels, rows from the top. Pixel (i, j) covers [i, i+1] x [j, j+1]. What lies
/// outside the image is clipped.
class Raster {
public:
    Raster(int width, int height, Color ground = {255, 255, 255});

    int width() const { return width_; }
    int height() const { return height_; }
    Color at(int x, int y) const { return pixels_[place(x, y)]; }
    void set(int x, int y, Color color) { pixels_[place(x, y)] = color; }

    /// A line with round ends. Pixels partly covered are mixed.
    void stroke(SvgPoint from, SvgPoint to, double width, Color color);

    /// All pixels whose center is in the box.
    void fill(const SvgBox& box, Color color);

    /// Text in an own font of strokes for ASCII, as wide as svg_text_width; other characters become
    /// question marks. `anchor` is the place of the point on the baseline.
    void text(SvgPoint at, std::string_view text, double size, SvgAnchor anchor, Color color);

    /// A line, a text, or the inside of a box: a polygon whose first and third corners are its left
    /// upper and right lower ones. Other shapes are not drawn.
    void draw(const SvgShape& shape);

    /// Means of squares of so many pixels a side, which divides both sizes.
    Raster reduced(int factor) const;

    /// As a PNG file: 8 bits a channel, without time stamp; equal images give equal files.
    std::string to_png() const;

    /// The number of a pixel, row by row.
    std::size_t place(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
               static_cast<std::size_t>(x);
    }

private:
    int width_, height_;
    std::vector<Color> pixels_;
};

} // namespace polydec
