// SPDX-License-Identifier: MIT
#include "examples/plots/plot_layout.h"
#include "examples/plots/svg_axis.h"
#include "examples/plots/svg_plot.h"
#include "io/pictures/svg_canvas.h"
#include "io/xml_text.h"
#include "tests/io/support.h"
#include "tests/io/svg_text.h"

namespace polydec::test::in_plots {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

SvgPlot parabola() {
    SvgPlot plot{"Errors", {"h"}, {"error"}};
    plot.series = {{"quads", {0.2, 0.1, 0.05}, {4e-2, 1e-2, 2.5e-3}}};
    return plot;
}

/// The pixels of the line of the first series.
std::vector<double> line_of(const SvgPlot& plot) {
    const auto text = to_svg(plot);
    return numbers_behind(text, "<title>" + plot.series[0].name, "points");
}

std::string plot_error(const SvgPlot& plot) {
    return error_of([&] { to_svg(plot); });
}

std::vector<std::string> labels(Scale scale, double low, double high) {
    std::vector<std::string> texts;
    for (const auto& tick : ticks(range_around(scale, low, high)))
        if (!tick.text.empty())
            texts.push_back(tick.text + (tick.exponent ? fmt::format("^{}", *tick.exponent) : ""));
    return texts;
}

using Texts = std::vector<std::string>;

TEST(Plots, AreWellFormedWhateverTheirTextsAre) {
    auto plot = parabola();
    plot.title = R"(a < b & "c" > d)";
    plot.title += "\xFF\xEF\xBF\xBF\xED\xA0\x80";
    plot.series.push_back({"<b> & \"e\"\x01", {0.1, 0.2}, {1, 2}, SvgTrace::markers});
    plot.series.push_back({"line", {0.1, 0.2}, {1, none}, SvgTrace::line});
    plot.slopes = {{2, 0}};
    const auto text = to_svg(plot);
    EXPECT_EQ(flaw(text), "");
    EXPECT_EQ(count(text, "a &lt; b &amp; &quot;c&quot; &gt; d"), 1U);
    EXPECT_EQ(count(text, "&lt;b&gt; &amp; &quot;e&quot;\xEF\xBF\xBD"), 2U) << "group and legend";
    EXPECT_EQ(xml_escaped("plain\ttext\n"), "plain\ttext\n");
    const std::string lost = "\xEF\xBF\xBD";
    for (const char* forbidden :
         {"\x01", "\x1F", "\r", "\xFF", "\xC3", "\xEF\xBF\xBE", "\xEF\xBF\xBF"})
        EXPECT_EQ(xml_escaped(std::string("\xC3\xA4") + forbidden + "<"),
                  "\xC3\xA4" + lost + "&lt;");
    EXPECT_EQ(xml_escaped("\xED\xA0\x80"), lost + lost + lost) << "a surrogate";
}

TEST(Plots, LinesOfPowersAreStraightOnLogarithmicAxesOnly) {
    const auto bend = [](const std::vector<double>& p) {
        return (p[2] - p[0]) * (p[5] - p[1]) - (p[4] - p[0]) * (p[3] - p[1]);
    };
    auto plot = parabola();
    const auto straight = line_of(plot);
    ASSERT_EQ(straight.size(), 6U);
    EXPECT_NEAR(bend(straight), 0, 10); // pixels are rounded to hundredths
    EXPECT_GT(straight[0], straight[2]) << "x runs to the right";
    EXPECT_LT(straight[1], straight[3]) << "and y upwards";
    // halfway in the logarithm
    EXPECT_NEAR(straight[2], (straight[0] + straight[4]) / 2, 0.011);

    plot.x.scale = plot.y.scale = Scale::linear;
    const auto bent = line_of(plot);
    EXPECT_GT(std::abs(bend(bent)), 1000);
    EXPECT_NEAR(bent[2], bent[4] + (bent[0] - bent[4]) / 3, 0.011);
}

TEST(Plots, PointsThatAreNanAreLeftOut) {
    auto plot = parabola();
    plot.series[0].y[1] = none;
    EXPECT_EQ(line_of(plot).size(), 4U);
    EXPECT_EQ(to_svg(plot).find("nan"), std::string::npos);
    plot.series[0].x[2] = none;
    EXPECT_EQ(count(to_svg(plot), "<circle"), 2U) << "one marker, one in the legend";
}

TEST(Plots, MarkersAndDashesTellSeriesApart) {
    auto plot = parabola();
    plot.series.assign(9, plot.series[0]);
    const auto text = to_svg(plot);
    std::vector<std::string> groups;
    for (std::size_t at = 0; (at = text.find("<g>", at)) != std::string::npos; ++at)
        groups.push_back(text.substr(at, text.find("</g>", at) - at));
    ASSERT_EQ(groups.size(), 9U);
    std::sort(groups.begin(), groups.end());
    EXPECT_EQ(std::unique(groups.begin(), groups.end()), groups.end());
}

TEST(Plots, TicksStandAtDecadesOrRoundNumbers) {
    EXPECT_EQ(labels(Scale::logarithmic, 2e-4, 0.5), (Texts{"10^-3", "10^-2", "10^-1"}));
    EXPECT_EQ(labels(Scale::logarithmic, 1e-19, 1).size(), 7U) << "every third";
    EXPECT_EQ(labels(Scale::logarithmic, 0.05, 0.4), (Texts{"0.05", "0.1", "0.2"}));
    EXPECT_EQ(labels(Scale::logarithmic, 2e-6, 1.1e-5), (Texts{"2·10^-6", "5·10^-6", "10^-5"}));
    EXPECT_EQ(labels(Scale::logarithmic, 3.1, 3.5), (Texts{"3.1", "3.2", "3.3", "3.4", "3.5"}));
    EXPECT_EQ(labels(Scale::logarithmic, 7, 7).size(), 3U);
    EXPECT_EQ(labels(Scale::linear, 0, 50), (Texts{"0", "10", "20", "30", "40", "50"}));
    EXPECT_EQ(labels(Scale::linear, -0.1, 0.1), (Texts{"-0.10", "-0.05", "0.00", "0.05", "0.10"}));
    EXPECT_EQ(labels(Scale::linear, 0, 0), (Texts{"-1.0", "-0.5", "0.0", "0.5", "1.0"}));
    for (const double factor : {1e-300, 1e-30, 1e-5, 1.0, 1e7, 1e30, 1e300})
        for (const auto scale : {Scale::linear, Scale::logarithmic})
            for (const double width : {1 + 1e-9, 1.01, 1.5, 4.0, 70.0, 1e6}) {
                const auto range = range_around(scale, factor, factor * width);
                const auto found = ticks(range);
                EXPECT_GE(found.size(), 2U) << factor << " " << width;
                EXPECT_LE(found.size(), 60U) << factor << " " << width;
                for (const auto& tick : found) {
                    EXPECT_GE(range.position(tick.value), -1e-9);
                    EXPECT_LE(range.position(tick.value), 1 + 1e-9);
                }
            }
}

TEST(Plots, SlopeTrianglesHaveTheSlopeAndCoverNoData) {
    for (const double slope : {-1.0, 1.0, 2.0, 4.0}) {
        auto plot = parabola();
        for (std::size_t i = 0; i < 3; ++i)
            plot.series[0].y[i] = std::pow(plot.series[0].x[i], slope);
        plot.slopes = {{slope, 0}};
        const auto text = to_svg(plot);
        const auto line = numbers_behind(text, "<title>quads", "points");
        const auto triangle = numbers_behind(text.substr(text.rfind("</g>")), "polygon", "points");
        ASSERT_EQ(triangle.size(), 6U);
        EXPECT_NEAR((triangle[3] - triangle[1]) / (triangle[2] - triangle[0]),
                    (line[5] - line[1]) / (line[4] - line[0]), 1e-3);

        SvgObstacles obstacles;
        add_line(obstacles, {{line[0], line[1]}, {line[2], line[3]}, {line[4], line[5]}});
        const SvgSlopeTriangle placed{
            {triangle[0], triangle[1]}, {triangle[2], triangle[3]}, {triangle[4], triangle[5]}};
        for (const auto& box : placed.boxes())
            EXPECT_EQ(meetings(obstacles, box.grown(-0.02)), 0U);
        EXPECT_EQ(count(text, fmt::format(">{:g}</text>", slope)), 1U + (slope == 1 ? 1U : 0U));
    }
}

TEST(Plots, LegendsStandInAFreeCornerOrBesideThePlot) {
    const SvgBox frame{0, 0, 400, 300};
    SvgObstacles rising, all;
    add_line(rising, {{0, 300}, {400, 0}});
    const auto corner = free_corner(100, 60, rising, frame);
    ASSERT_TRUE(corner);
    EXPECT_EQ(meetings(rising, *corner), 0U);
    EXPECT_EQ(corner->left, 8);
    EXPECT_EQ(corner->top, 8) << "upper left of a rising line";
    for (int i = 0; i < 10; ++i)
        add_line(all, {{0, 30.0 * i}, {400, 30.0 * i}});
    EXPECT_FALSE(free_corner(100, 60, all, frame));
    EXPECT_FALSE(free_corner(500, 60, {}, frame)) << "wider than the frame";

    auto plot = parabola();
    plot.series.assign(30, plot.series[0]);
    const auto narrow = line_of(plot), wide = line_of(parabola());
    EXPECT_LT(narrow[0], wide[0] - 50) << "the legend is beside the plot";
}

TEST(Plots, RefuseWhatCannotBeDrawn) {
    auto plot = parabola();
    plot.series[0].y[1] = 0;
    EXPECT_SAYS(plot_error(plot), "InvalidInput", "series 'quads'", "y[1]", "0", "logarithmic");
    plot.y.scale = Scale::linear;
    EXPECT_EQ(plot_error(plot), "");
    plot.slopes = {{2, 0}};
    EXPECT_SAYS(plot_error(plot), "InvalidInput", "slope triangle", "logarithmic");
    plot.series[0].x[2] = HUGE_VAL;
    EXPECT_SAYS(plot_error(plot), "InvalidInput", "series 'quads'", "x[2]", "infinite");
    plot.series[0].x = {1, none, none};
    plot.series[0].y = {none, 2, 3};
    EXPECT_SAYS(plot_error(plot), "InvalidInput", "series 'quads'", "no points");
    plot.series[0].x.pop_back();
    EXPECT_SAYS(plot_error(plot), "InvalidInput", "series 'quads'", "2 x", "3 y");
    plot.series.clear();
    EXPECT_SAYS(plot_error(plot), "InvalidInput", "plot 'Errors'", "no series");
    plot = parabola();
    plot.slopes = {{2, 1}};
    EXPECT_SAYS(plot_error(plot), "InvalidInput", "slope 2", "series 1", "1 series");
}

} // namespace polydec::test::in_plots
