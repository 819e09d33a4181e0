// SPDX-License-Identifier: MIT
#include "io/pictures/draw_structure.h"

#include "base/errors.h"
#include "complex/corners.h"
#include "dec/fields/cell_centers.h"
#include "dec/glued_box.h"
#include "dec/metric/rounding.h"
#include "io/pictures/draw_cells.h"
#include "io/pictures/structure_style.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

namespace polydec {

namespace {

constexpr const char* cell_color = "#E4E9EF";
constexpr double legible = 9; // least size of numbers, pixels

/// Points of an arc of an ellipse with these half axes, angles in parts of pi.
template <class See>
std::vector<SvgPoint> arc(const Eigen::Vector3d& center, const Eigen::Vector3d& u,
                          const Eigen::Vector3d& w, double begin, double end, int parts, See seen) {
    std::vector<SvgPoint> points;
    for (int i = 0; i <= parts; ++i) {
        const double angle = (begin + (end - begin) * i / parts) * std::numbers::pi;
        points.push_back(seen(center + std::cos(angle) * u + std::sin(angle) * w));
    }
    return points;
}

/// What a cell has over its own ground, in the order in which it is painted.
struct Strokes {
    std::vector<SvgShape> lines, marks;
};

class StructureDrawing {
public:
    StructureDrawing(const Discretization& mesh, const StructureOptions& options);

    SvgDrawing draw();

private:
    using Point = Eigen::Vector3d;

    Point at(const Points& rows, Index row) const {
        Point result = Point::Zero();
        result.head(rows.cols()) = rows.row(row);
        return result;
    }
    SvgPoint seen(const Point& point) const { return seen_at(view_, point); }
    std::pair<Index, Index> ends(Index edge) const;
    double middling_edge() const;
    void find_extent();
    void choose_text_size();
    bool is_closed() const;
    bool is_negative(Index edge) const;
    std::vector<std::vector<Index>> layers() const;

    SvgShape ground(Index cell) const;
    Strokes strokes(Index cell);
    void add_removed(Index cell, Strokes& strokes) const;
    void add_duals(Index cell, Strokes& strokes) const;
    void add_circle(Index cell, Strokes& strokes) const;
    void add_orientations(Index cell, Strokes& strokes) const;
    void add_numbers(Index cell, Strokes& strokes);
    void add_number(const Point& place, Index number, const char* color, Strokes& strokes) const;
    Point middle(Index cell) const;
    void add_words();

    const Discretization& mesh_;
    const Points& points_; // of its vertices, in its unit
    const StructureOptions& options_;
    SolidView view_;
    bool is_plane_;
    Points centers_, edge_centers_;
    std::vector<std::vector<Index>> corners_, removed_; ///< of each cell; edges of the pieces
    std::array<std::vector<Index>, 3> numbers_;         ///< of the cells, in the mesh that is given
    std::array<std::vector<bool>, 2> is_numbered_;      ///< vertices, edges
    SvgPoint low_, high_;
    double text_size_ = 12, pixel_ = 1; ///< pixels; world units a pixel
    SvgDrawing drawing_;
};

StructureDrawing::StructureDrawing(const Discretization& given, const StructureOptions& options)
    : mesh_(placed(given)),
      points_(mesh_.measured_points()),
      options_(options),
      view_(options.view),
      is_plane_(points_.cols() == 2 ||
                (points_.cols() == 3 && points_.col(2).maxCoeff() == points_.col(2).minCoeff())),
      removed_(mesh_.dimension() == 2 ? static_cast<std::size_t>(mesh_.complex().size(2)) : 0) {
    const Discretization& mesh = mesh_;
    if (mesh.dimension() != 2 || points_.cols() < 2 || points_.cols() > 3)
        throw InvalidInput(fmt::format("cells of dimension {} in {} coordinates: a drawing of the "
                                       "structure shows polygons in the plane or in space; a page "
                                       "shows solids",
                                       mesh.dimension(), points_.cols()));
    if (!mesh.passage().is_identity())
        throw InvalidInput(
            "flipped edges are not straight lines: draw the mesh without flips, or as a page");
    if (is_plane_) {
        view_.eye = Point(0, 0, 1);
        view_.up = Point(0, 1, 0);
    }
    for (int k = 0; k <= 2; ++k)
        numbers_[k] = cells_of_places(given, k);
    centers_ = cell_centers(mesh, 2) / mesh.unit();
    edge_centers_ = cell_centers(mesh, 1) / mesh.unit();
    for (Index cell = 0; cell < mesh.complex().size(2); ++cell)
        corners_.push_back(corners(mesh.merging(), cell));
    const auto& carriers = mesh.merging().carriers(1);
    for (Index edge = 0; edge < std::ssize(carriers); ++edge)
        if (carriers[edge].dimension == 2)
            removed_[carriers[edge].cell].push_back(edge);
}

std::pair<Index, Index> StructureDrawing::ends(Index edge) const {
    std::pair<Index, Index> result;
    for (const auto& [vertex, sign] : mesh_.complex().incidences(0)[edge])
        (sign < 0 ? result.first : result.second) = vertex;
    return result;
}

double StructureDrawing::middling_edge() const {
    std::vector<double> lengths;
    for (Index edge = 0; edge < mesh_.complex().size(1); ++edge) {
        const auto [a, b] = ends(edge);
        lengths.push_back((at(points_, a) - at(points_, b)).norm());
    }
    const auto middle = lengths.begin() + std::ssize(lengths) / 2;
    std::nth_element(lengths.begin(), middle, lengths.end());
    return *middle;
}

void StructureDrawing::find_extent() {
    constexpr double most = std::numeric_limits<double>::infinity();
    low_ = {most, most};
    high_ = {-most, -most};
    const auto add = [this](const Point& place, double around) {
        const SvgPoint p = seen(place);
        for (int axis = 0; axis < 2; ++axis) {
            low_[axis] = std::min(low_[axis], p[axis] - around);
            high_[axis] = std::max(high_[axis], p[axis] + around);
        }
    };
    for (Index v = 0; v < mesh_.complex().size(0); ++v)
        add(at(points_, v), 0);
    for (Index cell = 0; cell < mesh_.complex().size(2); ++cell) {
        const Point center = at(centers_, cell);
        if (options_.circumcircles)
            add(center, (at(points_, corners_[cell].front()) - center).norm());
        else if (options_.duals)
            add(center, 0);
    }
}

/// Numbers are as large as the edges between them allow.
void StructureDrawing::choose_text_size() {
    const double across = std::max(high_[0] - low_[0], (high_[1] - low_[1]) / 2);
    pixel_ = across / (drawing_.width - 2 * drawing_.margin);
    const double fitting = middling_edge() / pixel_ / 5;
    text_size_ = std::clamp(fitting, legible, 15.0);
    if (options_.numbers && fitting < legible)
        throw InvalidInput(fmt::format(
            "{} edges are too many for legible numbers in a drawing {} pixels wide: draw it {:.0f} "
            "wide, or without numbers",
            mesh_.complex().size(1), drawing_.width,
            std::ceil(drawing_.width * legible / fitting)));
}

/// Whether every edge has two cells, which look outward.
bool StructureDrawing::is_closed() const {
    if (!mesh_.pieces().orientable())
        return false;
    std::vector<int> sides(static_cast<std::size_t>(mesh_.complex().size(1)), 0);
    double volume = 0;
    for (Index cell = 0; cell < mesh_.complex().size(2); ++cell) {
        for (const auto& [edge, sign] : mesh_.complex().incidences(1)[cell])
            ++sides[edge];
        const auto& ring = corners_[cell];
        const Point first = at(points_, ring[0]);
        for (std::size_t i = 2; i < ring.size(); ++i)
            volume += first.dot(at(points_, ring[i - 1]).cross(at(points_, ring[i])));
    }
    return volume > 0 && std::all_of(sides.begin(), sides.end(), [](int n) { return n == 2; });
}

/// Whether its dual has a length below zero that is no error of rounding.
bool StructureDrawing::is_negative(Index edge) const {
    const double length = mesh_.volumes().dual(1)[edge];
    return length < 0 && !is_zero(length, mesh_.volumes().terms(1)[edge]);
}

/// Cells that do not hide each other, from far to near.
std::vector<std::vector<Index>> StructureDrawing::layers() const {
    std::vector<Index> all(corners_.size());
    std::iota(all.begin(), all.end(), 0);
    if (is_plane_)
        return {all};
    SolidFaces faces{.polygons = polygon_mesh(mesh_.merging(), points_)};
    faces.closed = is_closed();
    std::vector<std::vector<Index>> result;
    for (const Index cell : painting_order(faces, view_))
        result.push_back({cell});
    return result;
}

/// The mean of the corners, inside where cells are convex.
StructureDrawing::Point StructureDrawing::middle(Index cell) const {
    Point sum = Point::Zero();
    for (const Index v : corners_[cell])
        sum += at(points_, v);
    return sum / static_cast<double>(corners_[cell].size());
}

SvgShape StructureDrawing::ground(Index cell) const {
    SvgPolygon polygon{{}, edge_style()};
    polygon.style.fill = cell_color;
    for (const Index v : corners_[cell])
        polygon.points.push_back(seen(at(points_, v)));
    return polygon;
}

void StructureDrawing::add_removed(Index cell, Strokes& strokes) const {
    const auto& ends_of_pieces = mesh_.pieces().simplices(1);
    for (const Index edge : removed_[cell])
        strokes.lines.emplace_back(SvgPolyline{{seen(at(points_, ends_of_pieces(edge, 0))),
                                                seen(at(points_, ends_of_pieces(edge, 1)))},
                                               removed_style()});
}

/// The part of each dual edge that belongs to the cell.
void StructureDrawing::add_duals(Index cell, Strokes& strokes) const {
    const SvgPoint center = seen(at(centers_, cell));
    for (const auto& [edge, sign] : mesh_.complex().incidences(1)[cell])
        strokes.lines.emplace_back(
            SvgPolyline{{center, seen(at(edge_centers_, edge))},
                        is_negative(edge) ? negative_style() : dual_style()});
    strokes.marks.emplace_back(SvgDot{center, 3, {.stroke = "none", .fill = dual_style().stroke}});
}

/// An ellipse where the cell is seen askew.
void StructureDrawing::add_circle(Index cell, Strokes& strokes) const {
    const SvgStyle style = circle_style();
    const Point center = at(centers_, cell);
    const Point out = at(points_, corners_[cell].front()) - center;
    strokes.marks.emplace_back(SvgDot{seen(center), 2.5, {.stroke = "none", .fill = style.stroke}});
    if (is_plane_) {
        strokes.marks.emplace_back(SvgCircle{seen(center), out.norm(), style});
        return;
    }
    // another direction of the plane, from the corner that is farthest from the first one's line
    Point other = Point::Zero();
    for (const Index v : corners_[cell]) {
        const Point arm = at(points_, v) - center;
        const Point across = arm - arm.dot(out) / out.squaredNorm() * out;
        other = across.norm() > other.norm() ? across : other;
    }
    other *= out.norm() / other.norm();
    const auto see = [this](const Point& point) { return seen(point); };
    strokes.marks.emplace_back(SvgPolyline{arc(center, out, other, 0, 2, 72, see), style});
}

/// A head on each edge, and three quarters of a circle around the cell as its boundary runs.
void StructureDrawing::add_orientations(Index cell, Strokes& strokes) const {
    for (const auto& [edge, sign] : mesh_.complex().incidences(1)[cell]) {
        const auto [a, b] = ends(edge);
        const Point from = at(points_, a), along = at(points_, b) - from;
        strokes.marks.emplace_back(
            SvgArrow{seen(from + 0.66 * along), seen(from + 0.78 * along), edge_style()});
    }
    const Point center = middle(cell), first = at(points_, corners_[cell][0]) - center;
    const Point second = at(points_, corners_[cell][1]) - center;
    double room = std::numeric_limits<double>::infinity();
    for (const auto& [edge, sign] : mesh_.complex().incidences(1)[cell])
        room = std::min(room, (at(edge_centers_, edge) - center).norm());
    const Point u = first.normalized();
    const Point w = (second - second.dot(u) * u).normalized();
    const double radius = 0.45 * room;
    const auto turn = arc(center, radius * u, radius * w, 0.25, 1.75, 27,
                          [this](const Point& point) { return seen(point); });
    strokes.marks.emplace_back(SvgPolyline{{turn.begin(), turn.end() - 2}, turn_style()});
    strokes.marks.emplace_back(SvgArrow{turn[turn.size() - 4], turn.back(), turn_style()});
}

void StructureDrawing::add_number(const Point& place, Index number, const char* color,
                                  Strokes& strokes) const {
    auto [x, y] = seen(place);
    strokes.marks.emplace_back(
        SvgDot{{x, y}, 0.62 * text_size_, {.stroke = "none", .fill = "#ffffff", .opacity = 0.85}});
    y -= 0.35 * text_size_ * pixel_;
    strokes.marks.emplace_back(
        SvgText{{x, y}, std::to_string(number), text_size_, SvgAnchor::middle, color});
}

void StructureDrawing::add_numbers(Index cell, Strokes& strokes) {
    const auto add_once = [&](int k, Index number, const Point& place, const char* color) {
        if (numbers_[k][number] < 0 || (is_plane_ && is_numbered_[k][number]))
            return;
        is_numbered_[k][number] = true;
        add_number(place, numbers_[k][number], color, strokes);
    };
    for (const auto& [edge, sign] : mesh_.complex().incidences(1)[cell]) {
        const auto [a, b] = ends(edge);
        add_once(1, edge, 0.5 * (at(points_, a) + at(points_, b)), number_color);
    }
    for (const Index v : corners_[cell])
        add_once(0, v, at(points_, v), edge_color);
    add_number(middle(cell), numbers_[2][cell], turn_color, strokes);
}

Strokes StructureDrawing::strokes(Index cell) {
    Strokes result;
    add_removed(cell, result);
    if (options_.duals)
        add_duals(cell, result);
    if (options_.circumcircles)
        add_circle(cell, result);
    if (options_.orientations)
        add_orientations(cell, result);
    if (options_.numbers)
        add_numbers(cell, result);
    return result;
}

/// What the kinds of lines and numbers are.
void StructureDrawing::add_words() {
    std::vector<LineInWords> rows{{edge_style(), "edges of the cells"}};
    if (std::any_of(removed_.begin(), removed_.end(),
                    [](const auto& edges) { return !edges.empty(); }))
        rows.push_back({removed_style(), "edges merged away: their duals have no length"});
    if (options_.duals)
        rows.push_back({dual_style(), "dual edges, dots: centers of cells"});
    bool any_negative = false;
    for (Index edge = 0; edge < mesh_.complex().size(1); ++edge)
        any_negative = any_negative || is_negative(edge);
    if (options_.duals && any_negative)
        rows.push_back({negative_style(), "dual edges of negative length"});
    if (options_.circumcircles)
        rows.push_back({circle_style(), "circumcircles of the cells"});
    if (options_.orientations)
        rows.push_back({turn_style(), "orientations: heads on edges, arcs in cells"});
    if (options_.numbers)
        rows.push_back(
            {{.stroke = "none"}, "numbers of vertices (black), edges (orange), cells (purple)"});
    tell_lines(drawing_, rows, low_, pixel_);
}

SvgDrawing StructureDrawing::draw() {
    drawing_.title = view_.title;
    drawing_.width = view_.width;
    drawing_.margin = 24;
    find_extent();
    choose_text_size();
    for (int k = 0; k < 2; ++k)
        is_numbered_[k].resize(static_cast<std::size_t>(mesh_.complex().size(k)));
    for (const auto& layer : layers()) {
        std::vector<Strokes> all;
        for (const Index cell : layer) {
            drawing_.shapes.push_back(ground(cell));
            all.push_back(strokes(cell));
        }
        for (const auto part : {&Strokes::lines, &Strokes::marks})
            for (auto& own : all)
                std::move((own.*part).begin(), (own.*part).end(),
                          std::back_inserter(drawing_.shapes));
    }
    if (options_.words)
        add_words();
    return std::move(drawing_);
}

} // namespace

SvgDrawing draw_structure(const Discretization& mesh, const StructureOptions& options) {
    return StructureDrawing(mesh, options).draw();
}

} // namespace polydec
