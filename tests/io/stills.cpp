// SPDX-License-Identifier: MIT
//
// Parts of still pictures. Whole pictures are tested in tests/tools/stills.py.
#include "io/deflate.h"
#include "io/pages/surface_painter.h"
#include "io/pictures/stroke_font.h"
#include "tests/support/test.h"

namespace polydec::test::in_stills {

constexpr Color white{255, 255, 255}, gray{100, 100, 100};

/// A triangle that covers a picture of this size, at one nearness.
SeenTriangle cover(double size, double nearness) {
    return {.corners = {Eigen::Vector3d(-size, -size, nearness),
                        Eigen::Vector3d(4 * size, -size, nearness),
                        Eigen::Vector3d(-size, 4 * size, nearness)}};
}

int off(const Color& a, const Color& b) {
    int most = 0;
    for (std::size_t i = 0; i < 3; ++i)
        most = std::max(most, std::abs(a[i] - b[i]));
    return most;
}

TEST(Stills, TheNearestTriangleIsSeenInAnyOrder) {
    SeenTriangle near = cover(10, 2), far = cover(10, 1);
    near.brightness = 0.5;
    for (const bool is_near_first : {true, false}) {
        SurfacePainter painter(10, 10, {}, gray);
        painter.paint(is_near_first ? near : far);
        painter.paint(is_near_first ? far : near);
        EXPECT_EQ(painter.picture().at(5, 5), (Color{50, 50, 50}));
        EXPECT_TRUE(painter.shows({5, 5, 2}));
        EXPECT_FALSE(painter.shows({5, 5, -20}));
    }
}

TEST(Stills, AValueHasTheColorOfItsPlaceOnTheMap) {
    SeenTriangle triangle = cover(40, 0);
    triangle.parts = {0, 1, 0}; // from left to right, 200 pixels
    for (const ColorMap map : {ColorMap::sequential, ColorMap::diverging}) {
        SurfacePainter painter(40, 40, fine_map(map), gray);
        painter.paint(triangle);
        for (const int x : {0, 7, 20, 39})
            EXPECT_LE(
                off(painter.picture().at(x, 11), color_of(color_at(map, (x + 0.5 + 40) / 200))), 2);
    }
}

TEST(ColorMaps, HavePlacesInProportionToValuesOfAnyFiniteRange) {
    for (const double scale : {5e-324, 1e-300, 1.0, std::numeric_limits<double>::max()})
        for (const bool is_signed : {false, true}) {
            const auto range = color_range(is_signed ? -scale : 0, scale);
            EXPECT_EQ(range.part(range.low), 0) << scale;
            EXPECT_EQ(range.part(range.high), 1) << scale;
            if (scale < 1e-320) // has no half
                continue;
            EXPECT_EQ(range.part(range.middle()), 0.5) << scale;
            EXPECT_NEAR(range.part(0.75 * scale), is_signed ? 0.875 : 0.75, 1e-15) << scale;
        }
    EXPECT_EQ(color_range(3, 3).part(3), 0.5);
}

TEST(Stills, WhatNoTriangleCoversIsWhite) {
    SurfacePainter painter(10, 10, {}, gray);
    painter.paint({.corners = {Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(5, 0, 0),
                               Eigen::Vector3d(0, 5, 0)}});
    EXPECT_EQ(painter.picture().at(1, 1), gray);
    EXPECT_EQ(painter.picture().at(8, 8), white);
    EXPECT_FALSE(painter.shows({8, 8, 0}));
}

TEST(Stills, SidesHaveLinesInside) {
    SeenTriangle triangle = cover(10, 0);
    triangle.corners[0] = {0, 0, 0};
    triangle.corners[1] = {40, 0, 0};
    triangle.corners[2] = {0, 40, 0};
    triangle.sides[0] = Color{0, 0, 0};
    triangle.side_width = 2;
    SurfacePainter painter(10, 10, {}, gray);
    painter.paint(triangle);
    EXPECT_EQ(painter.picture().at(5, 1), (Color{0, 0, 0}));
    EXPECT_EQ(painter.picture().at(5, 2), gray);
    EXPECT_EQ(painter.picture().at(0, 5), gray);
}

TEST(Stills, APngFileHoldsThePixels) {
    Raster raster(2, 3);
    raster.set(1, 0, {10, 20, 30});
    raster.set(0, 2, {40, 50, 60});
    const std::string png = raster.to_png();
    const auto at = png.find("IDAT");
    const auto rows = inflate(png.substr(at + 4, png.size() - at - 4 - 4 - 12), 3 * 7);
    ASSERT_TRUE(rows);
    std::vector<unsigned char> above(6, 0);
    for (int y = 0; y < 3; ++y)
        for (int i = 0; i < 6; ++i) {
            EXPECT_EQ((*rows)[7 * y], 2); // the difference from the row above
            above[i] = static_cast<unsigned char>(above[i] + (*rows)[7 * y + 1 + i]);
            EXPECT_EQ(above[i], raster.at(i / 3, y)[i % 3]) << i << " " << y;
        }
}

TEST(Stills, EveryCharacterHasAGlyphOfItsOwn) {
    std::set<std::string_view> glyphs;
    for (char c = '!'; c <= '~'; ++c)
        if (c != 'O') // the digit 0 looks like it
            glyphs.insert(glyph(c));
    EXPECT_EQ(glyphs.size(), 93U);
    EXPECT_EQ(glyph('\n'), glyph('?'));
}

TEST(Stills, TextFillsItsWidth) {
    const std::string text = "mmmmmmmm";
    for (const SvgAnchor anchor : {SvgAnchor::start, SvgAnchor::end}) {
        Raster raster(200, 40);
        raster.text({100, 25}, text, 16, anchor, {0, 0, 0});
        int first = 200, last = 0;
        for (int y = 0; y < 40; ++y)
            for (int x = 0; x < 200; ++x)
                if (raster.at(x, y) != white) {
                    first = std::min(first, x);
                    last = std::max(last, x);
                }
        const double width = svg_text_width(text, 16);
        EXPECT_GE(first, 100 - (anchor == SvgAnchor::end ? width : 0) - 1);
        EXPECT_LE(last, 100 + (anchor == SvgAnchor::end ? 0 : width) + 1);
        EXPECT_GT(last - first, 0.85 * width);
    }
}

} // namespace polydec::test::in_stills
