// SPDX-License-Identifier: MIT
#include "io/pages/still.h"

#include "io/pages/projection.h"
#include "io/pages/still_scene.h"
#include "io/pages/surface_painter.h"
#include "io/pictures/lighting.h"
#include "io/pictures/upright_view.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace polydec {

namespace {

constexpr int picture_width = 1280, picture_height = 800;
constexpr Index most_svg_triangles = 4000, most_cells_with_edges = 2000;
constexpr double margin = 24, bar_length = 384, bar_left = picture_width / 2.0 - bar_length / 2;
constexpr Color plain{0xe4, 0xe9, 0xef}, ink{0x22, 0x22, 0x22};
constexpr Color edge{0x44, 0x44, 0x44};

std::string number_text(double value) {
    return fmt::format("{:.4g}", value);
}

using Place = Projection::Place;

SvgPoint on_paper(const Place& p) {
    return {p[0], p[1]};
}

/// What lies over a picture, in pixels, y down.
using Shapes = std::vector<SvgShape>;

SvgShape line(std::vector<SvgPoint> points, double width, const Color& color) {
    return SvgPolyline{std::move(points), {.stroke = color_text(color), .width = width}};
}

/// A line with two short ones at its end.
void add_arrow(Shapes& overlay, SvgPoint from, SvgPoint to, double width, const Color& color) {
    const double x = to[0] - from[0], y = to[1] - from[1], head = 0.32;
    const auto barb = [&](double side) {
        return SvgPoint{to[0] - head * (x + side * y), to[1] - head * (y - side * x)};
    };
    overlay.push_back(line({from, to}, width, color));
    overlay.push_back(line({barb(0.7), to, barb(-0.7)}, width, color));
}

/// Draws on a raster or a canvas.
template <class Paper>
void draw(Paper& paper, const Shapes& overlay) {
    for (const SvgShape& shape : overlay)
        paper.draw(shape);
}

SvgBox frame_of(const StillScenes& scenes) {
    const bool has_head = !scenes.page().text.title.empty() || !scenes.page().steps.empty();
    return {margin, has_head ? 60.0 : margin, picture_width - margin,
            picture_height - (scenes.range() ? 104.0 : margin)};
}

class StillPictures {
public:
    explicit StillPictures(const PageContent& content)
        : scenes_(content),
          projection_(scenes_.view(), scenes_.points(), scenes_.corners(), frame_of(scenes_)),
          is_flat_(is_flat(content.page.grid.points)) {
        if (scenes_.range())
            map_ = fine_map(scenes_.range()->map);
    }

    StillView view(std::size_t step) const {
        const StillScene scene = scenes_.at(step);
        const SurfacePainter painter = painted(scene);
        Raster raster = painter.picture();
        draw(raster, lines(scene, painter));
        std::string thumbnail = raster.reduced(8).to_png();
        draw(raster, overlay(scene, painter));
        return {raster.to_png(), std::move(thumbnail), words(scene)};
    }

    std::string svg(std::size_t step) const {
        const StillScene scene = scenes_.at(step);
        const SurfacePainter painter = painted(scene);
        SvgCanvas canvas(picture_width, picture_height);
        const auto drawn = scenes_.corners().size() / (scenes_.is_curve() ? 2 : 3);
        if (drawn > most_svg_triangles) {
            Raster raster = painter.picture();
            draw(raster, lines(scene, painter));
            canvas.image({0, 0}, picture_width, picture_height, raster.to_png());
        } else if (scenes_.is_curve()) {
            draw(canvas, lines(scene, painter));
        } else {
            add_polygons(canvas, scene, painter);
        }
        draw(canvas, overlay(scene, painter));
        return canvas.finish();
    }

private:
    SeenTriangle triangle(const StillScene& scene, const SurfacePainter& painter,
                          std::size_t t) const {
        SeenTriangle seen;
        for (std::size_t i = 0; i < 3; ++i)
            seen.corners[i] = projection_(scenes_.points(), scenes_.corners()[3 * t + i]);
        if (!scene.values.empty()) {
            seen.parts.emplace();
            for (std::size_t i = 0; i < 3; ++i)
                (*seen.parts)[i] = scenes_.range()->part(scene.values[3 * t + i]);
        }
        if (!is_flat_)
            seen.brightness = brightness((seen.corners[1] - seen.corners[0])
                                             .cross(seen.corners[2] - seen.corners[0])
                                             .cwiseProduct(Place(1, -1, 1)));
        add_sides(seen, scene, painter, t);
        return seen;
    }

    void add_sides(SeenTriangle& seen, const StillScene& scene, const SurfacePainter& painter,
                   std::size_t t) const {
        for (std::size_t i = 0; i < 3; ++i) {
            const bool is_edge = (scenes_.sides()[t] >> 2 * i & 3) == PageFaces::edge;
            if (is_edge && scenes_.cells() <= most_cells_with_edges)
                seen.sides[i] = edge;
            if (!scene.side_values.empty() && !std::isnan(scene.side_values[3 * t + i])) {
                seen.sides[i] = painter.color(scenes_.range()->part(scene.side_values[3 * t + i]));
                seen.side_width = 2;
            }
        }
    }

    SurfacePainter painted(const StillScene& scene) const {
        SurfacePainter painter(picture_width, picture_height, map_, plain);
        if (!scenes_.is_curve())
            for (std::size_t t = 0; t < scenes_.sides().size(); ++t)
                painter.paint(triangle(scene, painter, t));
        return painter;
    }

    /// The lines of curves, from far to near.
    Shapes lines(const StillScene& scene, const SurfacePainter& painter) const {
        Shapes result;
        if (!scenes_.is_curve())
            return result;
        std::vector<std::pair<double, SvgShape>> strokes;
        for (std::size_t i = 0; i + 1 < scenes_.corners().size(); i += 2) {
            const Place a = projection_(scenes_.points(), scenes_.corners()[i]);
            const Place b = projection_(scenes_.points(), scenes_.corners()[i + 1]);
            Color color = ink;
            if (!scene.values.empty())
                color = painter.color(
                    scenes_.range()->part(scene.values[i] / 2 + scene.values[i + 1] / 2));
            strokes.emplace_back(a[2] + b[2], line({on_paper(a), on_paper(b)}, 3, color));
        }
        std::stable_sort(strokes.begin(), strokes.end(),
                         [](const auto& a, const auto& b) { return a.first < b.first; });
        for (auto& [nearness, stroke] : strokes)
            result.push_back(std::move(stroke));
        return result;
    }

    Shapes overlay(const StillScene& scene, const SurfacePainter& painter) const {
        Shapes result;
        add_paths(result, painter);
        add_arrows(result, scene, painter);
        if (scenes_.range())
            add_bar(result, painter);
        add_head(result, scene);
        if (scenes_.range())
            add_numbers(result);
        return result;
    }

    void add_paths(Shapes& result, const SurfacePainter& painter) const {
        for (const PageArrows& arrows : scenes_.page().arrows) {
            if (!arrows.is_path())
                continue;
            const Mesh& lines = arrows.lines;
            const Points points = in_space(lines.points);
            for (Index i = 0; i < lines.simplices.rows(); ++i) {
                const Place a = projection_(points, lines.simplices(i, 0));
                const Place b = projection_(points, lines.simplices(i, 1));
                const double width = painter.shows((a + b) / 2) ? 3 : 0.8; // thin behind the mesh
                result.push_back(line({on_paper(a), on_paper(b)}, width, ink));
            }
        }
    }

    /// At most one in each square of a grid, the nearest one to its middle, as far as all of it is
    /// on the surface. Squares are as large as there is room for one of each.
    void add_arrows(Shapes& result, const StillScene& scene, const SurfacePainter& painter) const {
        std::vector<std::pair<Place, Index>> seen;
        Place low = Place::Constant(picture_width), high = Place::Zero();
        for (Index i = 0; i < scene.sites.rows(); ++i) {
            const Place at = projection_(scene.sites, i);
            if (!painter.shows(at))
                continue;
            seen.emplace_back(at, i);
            low = low.cwiseMin(at);
            high = high.cwiseMax(at);
        }
        const double room = (high - low).head(2).prod() / static_cast<double>(seen.size());
        const double size = std::clamp(std::sqrt(std::max(0.0, room)), 28.0, 64.0);
        std::map<std::array<int, 2>, std::pair<double, std::size_t>> nearest;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            const double x = seen[i].first[0] / size, y = seen[i].first[1] / size;
            const std::array square{static_cast<int>(x), static_cast<int>(y)};
            const std::pair found{std::hypot(x - square[0] - 0.5, y - square[1] - 0.5), i};
            auto& known = nearest.try_emplace(square, found).first->second;
            known = std::min(known, found);
        }
        std::map<std::array<int, 2>, Place> drawn; // none near another one
        for (const auto& entry : nearest) {
            const std::array square = entry.first;
            const std::size_t found = entry.second.second;
            const Place at = seen[found].first;
            const auto is_near = [&](int x, int y) {
                const auto other = drawn.find({square[0] + x, square[1] + y});
                return other != drawn.end() && (other->second - at).head(2).norm() < 0.8 * size;
            };
            if (is_near(-1, -1) || is_near(-1, 0) || is_near(-1, 1) || is_near(0, -1))
                continue;
            drawn.emplace(square, at);
            add_arrow_at(result, painter, at, scene.vectors.row(seen[found].second).transpose(),
                         size);
        }
    }

    void add_arrow_at(Shapes& result, const SurfacePainter& painter, const Place& at,
                      const Place& vector, double size) const {
        const Place ray = projection_.along(vector);
        const double part = vector.norm() / scenes_.range()->high, pixels = ray.norm();
        if (!(part > 0.02) || !(pixels > 0))
            return;
        const Place half = ray * (0.45 * size * std::sqrt(part) / pixels);
        if (!painter.shows(at - half) || !painter.shows(at + half))
            return;
        constexpr Color light{255, 255, 255}; // around it, for dark colors
        add_arrow(result, on_paper(at - half), on_paper(at + half), 4, light);
        add_arrow(result, on_paper(at - half), on_paper(at + half), 1.4, ink);
    }

    /// The name of the values and their unit, with what is known about them.
    std::string legend() const {
        const auto& about = scenes_.about();
        const std::string unit = unit_in(about, scenes_.page().text);
        return fmt::format("{}{}{}{}", scenes_.name(),
                           unit.empty() ? "" : fmt::format(" [{}]", unit),
                           about.empty() ? "" : ": ", about);
    }

    std::string words(const StillScene& scene) const {
        if (!scenes_.range())
            return fmt::format("The mesh: {} cells.", scenes_.cells());
        const ColorRange& range = *scenes_.range();
        return fmt::format("Colors show {}, {}{}{}.", legend(),
                           range.is_constant ? "everywhere " + number_text(range.middle())
                                             : fmt::format("from {} to {}", number_text(range.low),
                                                           number_text(range.high)),
                           scene.vectors.rows() > 0 ? "; arrows show its direction" : "",
                           scene.time.empty() ? "" : fmt::format(", at t = {}", scene.time));
    }

    static void add_label(Shapes& result, SvgPoint at, std::string text, double size,
                          SvgAnchor anchor) {
        result.push_back(SvgText{at, std::move(text), size, anchor, color_text(ink)});
    }

    void add_head(Shapes& result, const StillScene& scene) const {
        const std::string time = scene.time.empty() ? "" : "t = " + scene.time;
        const double room = picture_width - 3 * margin - svg_text_width(time, 20);
        add_label(result, {margin, 38}, svg_shortened(scenes_.page().text.title, 20, room), 20,
                  SvgAnchor::start);
        add_label(result, {picture_width - margin, 38}, time, 20, SvgAnchor::end);
    }

    static void add_bar(Shapes& result, const SurfacePainter& painter) {
        constexpr int pieces = 128;
        constexpr double top = picture_height - 52, bottom = picture_height - 36;
        for (int i = 0; i < pieces; ++i) {
            const double left = bar_left + bar_length * i / pieces,
                         right = bar_left + bar_length * (i + 1) / pieces;
            result.push_back(SvgPolygon{
                {{left, top}, {right, top}, {right, bottom}, {left, bottom}},
                {.stroke = "none", .fill = color_text(painter.color((i + 0.5) / pieces))}});
        }
    }

    /// The name of what the bar shows above it, and its ends and middle in numbers below.
    void add_numbers(Shapes& result) const {
        const ColorRange& range = *scenes_.range();
        const double numbers[] = {range.low, range.middle(), range.high};
        for (int i = 0; i < 3; ++i)
            if (!range.is_constant || i == 1)
                add_label(result, {bar_left + bar_length * i / 2, picture_height - 16.0},
                          number_text(numbers[i]), 15, SvgAnchor::middle);
        add_label(result, {picture_width / 2.0, picture_height - 62.0},
                  svg_shortened(legend(), 16, picture_width - 2 * margin), 16, SvgAnchor::middle);
    }

    /// A part of a triangle in one color, with the lines on its sides.
    struct Piece {
        double nearness;
        std::vector<SvgPoint> corners;
        Color color;
        Shapes lines;
    };

    /// Triangles with values at their corners are cut into `cuts` pieces along each side.
    void add_pieces(std::vector<Piece>& pieces, const SeenTriangle& seen,
                    const SurfacePainter& painter, int cuts) const {
        const auto at = [&](int i, int j) -> Place {
            return seen.corners[0] + (seen.corners[1] - seen.corners[0]) * i / cuts +
                   (seen.corners[2] - seen.corners[0]) * j / cuts;
        };
        const auto add = [&](std::array<std::array<int, 2>, 3> corners) {
            Piece piece{0, {}, {}, {}};
            double i = 0, j = 0;
            for (const auto& [a, b] : corners) {
                const Place corner = at(a, b);
                piece.corners.push_back(on_paper(corner));
                piece.nearness += corner[2] / 3;
                i += a / 3.0 / cuts;
                j += b / 3.0 / cuts;
            }
            piece.color = painter.color(seen, {1 - i - j, i, j});
            for (std::size_t side = 0; side < 3; ++side) {
                const auto& [a, b] = corners[side];
                const auto& [c, e] = corners[(side + 1) % 3];
                const bool outer[] = {b == 0 && e == 0, a + b == cuts && c + e == cuts,
                                      a == 0 && c == 0};
                for (std::size_t k = 0; k < 3; ++k)
                    if (outer[k] && seen.sides[k])
                        piece.lines.push_back(
                            line({piece.corners[side], piece.corners[(side + 1) % 3]},
                                 2 * seen.side_width, *seen.sides[k]));
            }
            pieces.push_back(std::move(piece));
        };
        for (int i = 0; i < cuts; ++i)
            for (int j = 0; i + j < cuts; ++j) {
                add({{{i, j}, {i + 1, j}, {i, j + 1}}});
                if (i + j + 1 < cuts)
                    add({{{i + 1, j}, {i + 1, j + 1}, {i, j + 1}}});
            }
    }

    void add_polygons(SvgCanvas& canvas, const StillScene& scene,
                      const SurfacePainter& painter) const {
        const std::size_t count = scenes_.sides().size();
        const int cuts = scene.values.empty()
                             ? 1
                             : static_cast<int>(std::clamp(
                                   std::sqrt(most_svg_triangles / double(count)), 1.0, 8.0));
        std::vector<Piece> pieces;
        for (std::size_t t = 0; t < count; ++t)
            add_pieces(pieces, triangle(scene, painter, t), painter, cuts);
        std::stable_sort(pieces.begin(), pieces.end(),
                         [](const Piece& a, const Piece& b) { return a.nearness < b.nearness; });
        for (const auto& piece : pieces) {
            const std::string color = color_text(piece.color);
            canvas.polygon(piece.corners, {.stroke = color, .fill = color, .width = 0.8});
            draw(canvas, piece.lines);
        }
    }

    StillScenes scenes_;
    Projection projection_;
    bool is_flat_;
    std::vector<Color> map_;
};

} // namespace

StillView still_view(const PageContent& content) {
    return StillPictures(content).view(content.shown.step);
}

std::string to_png(const Page& page) {
    return still_view(PageContent(page)).png;
}

std::string to_svg(const Page& page) {
    const PageContent content(page);
    return StillPictures(content).svg(content.shown.step);
}

void draw_steps(const Page& page, const std::function<void(const std::string& png)>& take) {
    const PageContent content(page);
    const StillPictures pictures(content);
    for (std::size_t step = 0; step < std::max<std::size_t>(1, page.steps.size()); ++step)
        take(pictures.view(step).png);
}

} // namespace polydec
