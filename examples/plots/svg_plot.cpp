// SPDX-License-Identifier: MIT
#include "examples/plots/svg_plot.h"

#include "base/errors.h"
#include "examples/plots/plot_layout.h"
#include "examples/plots/svg_axis.h"
#include "examples/plots/svg_traces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace polydec {

namespace {

constexpr const char* gray = "#b8b8b8";
constexpr const char* light_gray = "#ececec";
constexpr const char* dark = "#222222";
constexpr double label_size = 15, tick_size = 13;
constexpr double legend_row = 21, sample_width = 32, legend_margin = 9;

void check(const SvgSeries& series, const SvgAxis& axis, const char* which,
           const std::vector<double>& values) {
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (std::isinf(values[i]))
            throw InvalidInput(fmt::format("series '{}': {}[{}] is infinite; NaN would leave the "
                                           "point out",
                                           series.name, which, i));
        if (axis.scale == Scale::logarithmic && values[i] <= 0)
            throw InvalidInput(fmt::format("series '{}': {}[{}] = {} is not positive, but the axis "
                                           "is logarithmic; leave it out as NaN or make the axis "
                                           "linear",
                                           series.name, which, i, values[i]));
    }
}

bool is_there(const SvgSeries& series, std::size_t i) {
    return !std::isnan(series.x[i]) && !std::isnan(series.y[i]);
}

void check(const SvgPlot& plot) {
    if (plot.series.empty())
        throw InvalidInput(fmt::format("the plot '{}' has no series: add one", plot.title));
    for (const auto& series : plot.series) {
        if (series.x.size() != series.y.size())
            throw InvalidInput(fmt::format("series '{}' has {} x and {} y; expected as many",
                                           series.name, series.x.size(), series.y.size()));
        check(series, plot.x, "x", series.x);
        check(series, plot.y, "y", series.y);
        bool any = false;
        for (std::size_t i = 0; i < series.x.size(); ++i)
            any = any || is_there(series, i);
        if (!any)
            throw InvalidInput(fmt::format("series '{}' has no points: leave it out", series.name));
    }
    for (const auto& slope : plot.slopes) {
        if (plot.x.scale != Scale::logarithmic || plot.y.scale != Scale::logarithmic)
            throw InvalidInput("a slope triangle needs two logarithmic axes");
        if (slope.series >= plot.series.size() || !std::isfinite(slope.slope))
            throw InvalidInput(fmt::format("a slope triangle of slope {} at series {}: expected a "
                                           "finite slope and one of {} series",
                                           slope.slope, slope.series, plot.series.size()));
    }
}

SvgRange range_of(const SvgPlot& plot, const SvgAxis& axis,
                  std::vector<double> SvgSeries::*coordinates) {
    double least = std::numeric_limits<double>::infinity(), greatest = -least;
    for (const auto& series : plot.series)
        for (std::size_t i = 0; i < series.x.size(); ++i)
            if (is_there(series, i)) {
                least = std::min(least, (series.*coordinates)[i]);
                greatest = std::max(greatest, (series.*coordinates)[i]);
            }
    return range_around(axis.scale, least, greatest);
}

class Plotter {
public:
    explicit Plotter(const SvgPlot& plot)
        : plot_(plot),
          x_(range_of(plot, plot.x, &SvgSeries::x)),
          y_(range_of(plot, plot.y, &SvgSeries::y)),
          canvas_(plot.width, plot.height),
          frame_{84, plot.title.empty() ? 16.0 : 48.0, plot.width - 20, plot.height - 58} {
        arrange();
        if (legend_wanted() && !legend_) { // beside the plot, which becomes narrower
            frame_.right -= legend_width() + 10;
            arrange();
            legend_ = SvgBox{frame_.right + 10, frame_.top, frame_.right + 10 + legend_width(),
                             frame_.top + legend_height()};
        }
    }

    std::string draw() {
        if (!plot_.title.empty())
            canvas_.text({(frame_.left + frame_.right) / 2, 30}, plot_.title, {.size = 18});
        draw_axes();
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            canvas_.open_group(plot_.series[i].name);
            draw_trace(canvas_, i, plot_.series[i].trace, lines_[i]);
            canvas_.close_group();
        }
        for (std::size_t i = 0; i < triangles_.size(); ++i)
            draw_triangle(triangles_[i], plot_.slopes[i].slope);
        if (legend_)
            draw_legend();
        return canvas_.finish();
    }

private:
    double column(double x) const { return frame_.left + x_.position(x) * frame_.width(); }
    double row(double y) const { return frame_.bottom - y_.position(y) * frame_.height(); }

    /// Places lines, slope triangles and legend in the frame.
    void arrange() {
        lines_.clear();
        triangles_.clear();
        SvgObstacles obstacles;
        for (const auto& series : plot_.series) {
            lines_.emplace_back();
            for (std::size_t i = 0; i < series.x.size(); ++i)
                if (is_there(series, i))
                    lines_.back().push_back({column(series.x[i]), row(series.y[i])});
            if (series.trace == SvgTrace::markers)
                for (const auto& point : lines_.back())
                    add_line(obstacles, {point});
            else
                add_line(obstacles, lines_.back());
        }
        for (const auto& slope : plot_.slopes) {
            triangles_.push_back(triangle(slope, obstacles));
            for (const auto& box : triangles_.back().boxes())
                obstacles.push_back(box);
        }
        if (legend_wanted())
            legend_ = free_corner(legend_width(), legend_height(), obstacles, frame_);
    }

    SvgSlopeTriangle triangle(const SvgSlope& slope, const SvgObstacles& obstacles) const {
        const double decade_x = frame_.width() / (x_.high - x_.low);
        const double decade_y = frame_.height() / (y_.high - y_.low);
        double width = 0.14 * frame_.width();
        double rise = width * slope.slope * decade_y / decade_x;
        const double too_high = std::abs(rise) / (0.22 * frame_.height());
        if (too_high > 1) {
            width /= too_high;
            rise /= too_high;
        }
        return place_triangle(lines_[slope.series], width, rise, obstacles, frame_);
    }

    void draw_axes() {
        for (const auto& tick : ticks(x_)) {
            const double x = column(tick.value);
            grid_line({x, frame_.bottom}, {x, frame_.top}, tick);
            if (!tick.text.empty())
                canvas_.text({x, frame_.bottom + 19}, tick.text,
                             {.size = tick_size, .color = dark, .exponent = tick.exponent});
        }
        for (const auto& tick : ticks(y_)) {
            const double y = row(tick.value);
            grid_line({frame_.left, y}, {frame_.right, y}, tick);
            if (!tick.text.empty())
                canvas_.text({frame_.left - 7, y + 4.5}, tick.text,
                             {.size = tick_size,
                              .anchor = SvgAnchor::end,
                              .color = dark,
                              .exponent = tick.exponent});
        }
        canvas_.polygon({{frame_.left, frame_.top},
                         {frame_.right, frame_.top},
                         {frame_.right, frame_.bottom},
                         {frame_.left, frame_.bottom}},
                        {.stroke = dark, .width = 1});
        canvas_.text({(frame_.left + frame_.right) / 2, plot_.height - 14}, plot_.x.label,
                     {.size = label_size});
        canvas_.text({22, (frame_.top + frame_.bottom) / 2}, plot_.y.label,
                     {.size = label_size, .turned = -90});
    }

    /// A grid line at a labeled tick, and a short line at the axis.
    void grid_line(SvgPoint axis, SvgPoint end, const SvgTick& tick) {
        const bool major = !tick.text.empty();
        canvas_.polyline({axis, end}, {.stroke = major ? gray : light_gray, .width = 0.7});
        const double length = major ? 6 : 3,
                     across = std::hypot(end[0] - axis[0], end[1] - axis[1]);
        const SvgPoint inner{axis[0] + (end[0] - axis[0]) * length / across,
                             axis[1] + (end[1] - axis[1]) * length / across};
        canvas_.polyline({axis, inner}, {.stroke = dark, .width = 1});
    }

    void draw_triangle(const SvgSlopeTriangle& triangle, double slope) {
        const auto& [first, second, corner] = triangle;
        canvas_.polygon({first, second, corner},
                        {.stroke = dark, .fill = "#dddddd", .width = 1, .opacity = 0.6});
        const double x = (first[0] + second[0]) / 2, y = (first[1] + second[1]) / 2;
        const bool right = corner[0] > x, below = corner[1] > y;
        canvas_.text({corner[0] + (right ? 5 : -5), y + 4.5}, fmt::format("{:g}", slope),
                     {.size = tick_size, .anchor = right ? SvgAnchor::start : SvgAnchor::end});
        canvas_.text({x, corner[1] + (below ? 14 : -5)}, "1", {.size = tick_size});
    }

    bool legend_wanted() const {
        return plot_.series.size() > 1 || !plot_.series.front().name.empty();
    }
    double legend_height() const {
        return legend_row * static_cast<double>(plot_.series.size()) + legend_margin;
    }
    double legend_width() const {
        double widest = 0;
        for (const auto& series : plot_.series)
            widest = std::max(widest, svg_text_width(series.name, tick_size));
        return widest + sample_width + 3 * legend_margin;
    }

    void draw_legend() {
        const auto& box = *legend_;
        canvas_.polygon({{box.left, box.top},
                         {box.right, box.top},
                         {box.right, box.bottom},
                         {box.left, box.bottom}},
                        {.stroke = gray, .fill = "#ffffff", .width = 0.8});
        for (std::size_t i = 0; i < plot_.series.size(); ++i) {
            const double y =
                box.top + legend_margin / 2 + legend_row * (static_cast<double>(i) + 0.5);
            const double left = box.left + legend_margin;
            draw_trace_sample(canvas_, i, plot_.series[i].trace, {left, y}, sample_width);
            canvas_.text({left + sample_width + legend_margin, y + 4.5}, plot_.series[i].name,
                         {.size = tick_size, .anchor = SvgAnchor::start});
        }
    }

    const SvgPlot& plot_;
    SvgRange x_, y_;
    SvgCanvas canvas_;
    SvgBox frame_;
    std::vector<std::vector<SvgPoint>> lines_;
    std::vector<SvgSlopeTriangle> triangles_;
    std::optional<SvgBox> legend_;
};

} // namespace

std::string to_svg(const SvgPlot& plot) {
    check(plot);
    return Plotter(plot).draw();
}

} // namespace polydec
