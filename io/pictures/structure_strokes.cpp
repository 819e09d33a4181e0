// SPDX-License-Identifier: MIT
#include "io/pictures/structure_drawing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

namespace polydec {

/// Points of an arc of an ellipse with these half axes, angles in parts of pi.
std::vector<SvgPoint> StructureDrawing::arc(const Point& center, const Point& u, const Point& w,
                                            double begin, double end, int parts) const {
    std::vector<SvgPoint> points;
    for (int i = 0; i <= parts; ++i) {
        const double angle = (begin + (end - begin) * i / parts) * std::numbers::pi;
        points.push_back(seen(center + std::cos(angle) * u + std::sin(angle) * w));
    }
    return points;
}

/// The mean of the corners, inside where cells are convex.
StructureDrawing::Point StructureDrawing::middle(Index cell) const {
    Point sum = Point::Zero();
    for (const Index v : corners_[cell])
        sum += at(points_, v);
    return sum / static_cast<double>(corners_[cell].size());
}

/// The edges of a cell; in a chain the cell is one.
std::vector<Index> StructureDrawing::edges_of(Index cell) const {
    if (n_ == 1)
        return {cell};
    std::vector<Index> edges;
    for (const auto& [edge, sign] : mesh_.complex().incidences(1)[cell])
        edges.push_back(edge);
    return edges;
}

/// The k-cells of a cell, which have numbers.
std::vector<Index> StructureDrawing::numbered_at(int k, Index cell) const {
    if (k == 0)
        return corners_[cell];
    return k == 1 ? edges_of(cell) : std::vector<Index>(n_ - 1, cell);
}

SvgShape StructureDrawing::ground(Index cell) const {
    std::vector<SvgPoint> points;
    for (const Index v : corners_[cell])
        points.push_back(seen(at(points_, v)));
    if (n_ == 1)
        return SvgPolyline{std::move(points), chain_style()};
    SvgStyle style = edge_style();
    style.fill = cell_color;
    return SvgPolygon{std::move(points), style};
}

/// The dual cell, a band beneath a chain or an area on a surface.
std::vector<SvgShape> StructureDrawing::filled() const {
    std::vector<SvgShape> shapes;
    for (const auto& ring : rings_) {
        std::vector<SvgPoint> points;
        for (const auto& [degree, cell] : ring)
            points.push_back(seen(at(centers_[degree], cell)));
        if (n_ == 1)
            shapes.emplace_back(SvgPolyline{std::move(points), band_style()});
        else
            shapes.emplace_back(SvgPolygon{std::move(points), fill_style()});
    }
    return shapes;
}

void StructureDrawing::add_removed(Index cell, Strokes& strokes) const {
    const auto& ends_of_pieces = mesh_.pieces().simplices(1);
    for (const Index edge : removed_[cell])
        strokes.lines.emplace_back(SvgPolyline{{seen(at(points_, ends_of_pieces(edge, 0))),
                                                seen(at(points_, ends_of_pieces(edge, 1)))},
                                               removed_style()});
}

/// The part of each dual edge that belongs to the cell. Its head is where the dual derivative
/// counts the cell as the end, or where the dual begins if no cell is its end.
void StructureDrawing::add_duals(Index cell, Strokes& strokes) const {
    const SvgPoint center = seen(at(centers_[n_], cell));
    for (const auto& [facet, sign] : mesh_.complex().incidences(n_ - 1)[cell]) {
        const SvgPoint middle = seen(at(centers_[n_ - 1], facet));
        const SvgStyle style = is_negative(facet) ? negative_style() : dual_style();
        strokes.lines.emplace_back(SvgPolyline{{center, middle}, style});
        const bool ends_here = is_end_of_dual(sign);
        if (!options_.dual_orientations || (!ends_here && ends_in_cell_[facet]))
            continue;
        const auto& [from, to] = ends_here ? std::pair(middle, center) : std::pair(center, middle);
        const double dx = to[0] - from[0], dy = to[1] - from[1], length = std::hypot(dx, dy);
        const double tip = 0.75, tail = length > 0 ? tip - std::min(tip, 10 * pixel_ / length) : 0;
        strokes.marks.emplace_back(SvgArrow{{from[0] + tail * dx, from[1] + tail * dy},
                                            {from[0] + tip * dx, from[1] + tip * dy},
                                            style});
    }
    strokes.marks.emplace_back(SvgDot{center, 3, {.stroke = "none", .fill = dual_style().stroke}});
}

/// An ellipse where the cell is seen askew.
void StructureDrawing::add_circle(Index cell, Strokes& strokes) const {
    const SvgStyle style = circle_style();
    const Point center = at(centers_[n_], cell);
    const Point out = at(points_, corners_[cell].front()) - center;
    strokes.marks.emplace_back(SvgDot{seen(center), 2.5, {.stroke = "none", .fill = style.stroke}});
    if (is_plane_ || n_ == 1) {
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
    strokes.marks.emplace_back(SvgPolyline{arc(center, out, other, 0, 2, 72), style});
}

/// A head on each edge, and three quarters of a circle around the cell as its boundary runs.
void StructureDrawing::add_orientations(Index cell, Strokes& strokes) const {
    for (const Index edge : edges_of(cell)) {
        const auto [a, b] = ends(edge);
        const Point from = at(points_, a), along = at(points_, b) - from;
        strokes.marks.emplace_back(
            SvgArrow{seen(from + 0.66 * along), seen(from + 0.78 * along), edge_style()});
    }
    if (n_ == 1)
        return;
    const Point center = middle(cell), first = at(points_, corners_[cell][0]) - center;
    const Point second = at(points_, corners_[cell][1]) - center;
    double room = std::numeric_limits<double>::infinity();
    for (const Index edge : edges_of(cell))
        room = std::min(room, (at(centers_[1], edge) - center).norm());
    const Point u = first.normalized();
    const Point w = (second - second.dot(u) * u).normalized();
    const double radius = 0.45 * room;
    const auto turn = arc(center, radius * u, radius * w, 0.25, 1.75, 27);
    strokes.marks.emplace_back(SvgPolyline{{turn.begin(), turn.end() - 2}, turn_style()});
    strokes.marks.emplace_back(SvgArrow{turn[turn.size() - 4], turn.back(), turn_style()});
}

/// Places that suit a number, the best first: at the vertex, along the edge, or towards the
/// corners.
std::vector<SvgPoint> StructureDrawing::wishes(int k, Index cell) const {
    if (k == 0)
        return {seen(at(points_, cell))};
    std::vector<SvgPoint> places;
    if (k == 1) {
        const auto [a, b] = ends(cell);
        for (const double part : {0.5, 0.42, 0.58, 0.34, 0.66})
            places.push_back(seen((1 - part) * at(points_, a) + part * at(points_, b)));
        return places;
    }
    const Point center = middle(cell);
    places.push_back(seen(center));
    for (const double part : {0.2, 0.4})
        for (const Index v : corners_[cell])
            places.push_back(seen((1 - part) * center + part * at(points_, v)));
    return places;
}

/// A number at the first of these places that is free. If it is beside its cell, a thin line leads
/// there.
void StructureDrawing::add_number(const std::string& text, const char* color,
                                  const std::vector<SvgPoint>& places, SvgObstacles& taken) {
    const double height = 1.3 * text_size_ * pixel_;
    const double width = std::max(height, (svg_text_width(text, text_size_) + 1) * pixel_);
    const SvgPoint place = free_center(places, width, height, taken);
    taken.push_back(box_around(place, width, height));
    auto& shapes = drawing_.shapes;
    if (std::find(places.begin(), places.end(), place) == places.end())
        shapes.emplace_back(SvgPolyline{{places.front(), place}, {.stroke = color, .width = 0.7}});
    shapes.emplace_back(
        SvgDot{place, 0.62 * text_size_, {.stroke = "none", .fill = "#ffffff", .opacity = 0.85}});
    shapes.emplace_back(SvgText{{place[0], place[1] - 0.35 * text_size_ * pixel_},
                                text,
                                text_size_,
                                SvgAnchor::middle,
                                color});
}

/// The numbers of what nearer layers do not hide; those of vertices are placed first, then edges.
void StructureDrawing::add_numbers(const std::vector<std::vector<Index>>& layers) {
    std::array<std::map<Index, std::size_t>, 3> nearest; // layer of each cell, by degree
    for (std::size_t i = 0; i < layers.size(); ++i)
        for (const Index cell : layers[i])
            for (int k = 0; k <= n_; ++k)
                for (const Index own : numbered_at(k, cell))
                    nearest[k][own] = i;
    const auto is_hidden = [&](SvgPoint place, std::size_t layer) {
        for (std::size_t i = layer + 1; i < layers.size(); ++i)
            for (const Index cell : layers[i])
                if (covers(std::get<SvgPolygon>(ground(cell)).points, place))
                    return true;
        return false;
    };
    SvgObstacles taken;
    for (int k = 0; k <= n_; ++k)
        for (const auto& [cell, layer] : nearest[k]) {
            const auto places = wishes(k, cell);
            if (numbers_[k][cell] >= 0 && !is_hidden(places.front(), layer))
                add_number(std::to_string(numbers_[k][cell]), number_colors[k], places, taken);
        }
}

Strokes StructureDrawing::strokes(Index cell) const {
    Strokes result;
    if (n_ == 2)
        add_removed(cell, result);
    if (options_.duals)
        add_duals(cell, result);
    if (n_ == 1)
        for (const Index v : corners_[cell])
            result.lines.emplace_back(SvgDot{seen(at(points_, v)), 4});
    if (options_.circumcircles)
        add_circle(cell, result);
    if (options_.orientations)
        add_orientations(cell, result);
    return result;
}

} // namespace polydec
