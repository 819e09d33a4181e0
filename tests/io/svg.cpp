// SPDX-License-Identifier: MIT
#include "tests/io/support.h"
#include "tests/io/svg_text.h"

namespace polydec::test::in_svg {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

std::string drawing_error(std::vector<SvgShape> shapes) {
    return refusal([&] { to_svg(SvgDrawing{.shapes = std::move(shapes)}); });
}

TEST(Svg, FlawsOfXmlAreFound) {
    EXPECT_EQ(flaw("<g><a b=\"c\"/>x &amp; y</g>\n"), "");
    EXPECT_EQ(flaw("<g><a b=\"c\">x</g>\n"), "</g> closes nothing");
    EXPECT_EQ(flaw("<g>\n"), "<g> is not closed");
    EXPECT_EQ(flaw("<g>a & b</g>\n"), "a bare &");
    EXPECT_EQ(flaw("<g>a < b</g>\n"), "a stray bracket: a < b");
}

TEST(Svg, DrawingsScaleTheWorldAlikeInBothDirectionsAndUpwards) {
    SvgDrawing drawing{.width = 232, .margin = 16};
    drawing.shapes = {SvgPolygon{{{-1, 0}, {3, 0}, {3, 2}}}, SvgCircle{{1, 1}, 0.5},
                      SvgDot{{2, 1}, 7}};
    const auto text = to_svg(drawing);
    EXPECT_EQ(flaw(text), "");
    EXPECT_EQ(numbers_behind(text, "<svg", "height"), (std::vector<double>{132}));
    EXPECT_EQ(numbers_behind(text, "<polygon", "points"),
              (std::vector<double>{16, 116, 216, 116, 216, 16}));
    EXPECT_EQ(numbers_behind(text, "<circle", "cx"), (std::vector<double>{116}));
    EXPECT_EQ(numbers_behind(text, "<circle", "cy"), (std::vector<double>{66}));
    EXPECT_EQ(numbers_behind(text, "<circle", "r"), (std::vector<double>{25}));
    EXPECT_EQ(numbers_behind(text, "cx=\"166\"", "r"), (std::vector<double>{7})) << "pixels";
}

TEST(Svg, DrawingsHoldEveryShapeInItsStyle) {
    SvgDrawing drawing{.title = "A & B"};
    drawing.shapes = {SvgPolyline{{{0, 0}, {1, 0}}, {.stroke = "#ff0000", .dashes = {4, 2.5}}},
                      SvgPolygon{{{0, 0}, {1, 0}, {1, 1}}, {.fill = "#00ff00", .opacity = 0.25}},
                      SvgArrow{{0, 0}, {1, 1}, {.stroke = "#0000ff", .width = 2}},
                      SvgArrow{{1, 1}, {1, 1}},
                      SvgText{{0, 0}, "<here>", 12, SvgAnchor::end, "#123456"}};
    const auto text = to_svg(drawing);
    EXPECT_EQ(flaw(text), "");
    EXPECT_EQ(count(text, "stroke=\"#ff0000\" stroke-width=\"1\" stroke-dasharray=\"4 2.5\""), 1U);
    EXPECT_EQ(count(text, "fill=\"#00ff00\" stroke=\"#000000\" fill-opacity=\"0.25\""), 1U);
    EXPECT_EQ(count(text, "fill=\"#0000ff\" stroke=\"none\""), 1U) << "the head of the arrow";
    EXPECT_EQ(count(text, "text-anchor=\"end\" fill=\"#123456\">&lt;here&gt;</text>"), 1U);
    EXPECT_EQ(count(text, ">A &amp; B</text>"), 1U);
    EXPECT_EQ(count(text, "<polygon"), 2U) << "an arrow of no length has no head";
}

TEST(Svg, DrawingsRefuseWhatCannotBeDrawn) {
    const SvgDot dot{{0, 0}};
    EXPECT_SAYS(drawing_error({}), "drawing", "no shapes");
    EXPECT_SAYS(drawing_error({dot, SvgPolyline{}}), "shape 1", "no points");
    EXPECT_SAYS(drawing_error({dot, SvgCircle{{0, 0}, none}}), "shape 1", "coordinate", "NaN");
    EXPECT_SAYS(drawing_error({dot, dot}), "shapes", "one point");
    EXPECT_EQ(drawing_error({dot, SvgDot{{0, 1}}}), "accepted") << "a line of no width";
    const SvgDrawing narrow{.shapes = {SvgCircle{{0, 0}, 1}}, .width = 30, .margin = 15};
    EXPECT_REFUSED(to_svg(narrow), "30 pixels", "15");
}

} // namespace polydec::test::in_svg
