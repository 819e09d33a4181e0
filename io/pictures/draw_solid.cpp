// SPDX-License-Identifier: MIT
#include "io/pictures/draw_solid.h"

#include "base/checks.h"
#include "base/errors.h"
#include "complex/merging.h"
#include "dec/discretization/glued_box.h"
#include "dec/fields/cell_centers.h"
#include "io/pictures/lighting.h"
#include "io/pictures/svg_layout.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace polydec {

namespace {

using Place = Eigen::Vector3d;

/// The axes of the picture: to the right, up, towards the eye.
struct Frame {
    Place right, up, eye;

    explicit Frame(const SolidView& view) {
        for (const auto& [name, direction] : {std::pair("eye", &view.eye), {"up", &view.up}})
            if (direction->size() != 3 || !direction->allFinite())
                throw InvalidInput(fmt::format(
                    "the view's direction '{}' must have three finite coordinates", name));
            else if (direction->isZero(0))
                throw InvalidInput(fmt::format(
                    "the view's direction '{}' is zero: expected a vector that is not", name));
        eye = Place(view.eye).stableNormalized();
        right = Place(view.up).stableNormalized().cross(eye);
        if (!(right.norm() > 1e-9)) // seen along it, another axis is up
            right = (std::abs(eye.y()) < 0.5 ? Place::UnitY() : Place::UnitZ()).cross(eye);
        right.normalize();
        up = eye.cross(right);
    }

    SvgPoint operator()(const Place& p) const { return {right.dot(p), up.dot(p)}; }
    Place parts(const Place& p) const { return {right.dot(p), up.dot(p), eye.dot(p)}; }
};

Place mean_of(const Points& points, std::span<const Index> corners) {
    Place sum = Place::Zero();
    for (const Index v : corners)
        sum += points.row(v).transpose();
    return sum / static_cast<double>(corners.size());
}

Place mean_of(const PolygonMesh& polygons, Index face) {
    return mean_of(polygons.points, polygons.face(face));
}

/// Twice the area times the normal (Newell): corners run counterclockwise around it.
Place normal_of(const Points& points, std::span<const Index> corners) {
    Place normal = Place::Zero();
    const Place origin = points.row(corners.front());
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
        const Place a = points.row(corners[i]), b = points.row(corners[i + 1]);
        normal += (a - origin).cross(b - origin);
    }
    return normal;
}

Place normal_of(const PolygonMesh& polygons, Index face) {
    return normal_of(polygons.points, polygons.face(face));
}

bool is_color(const std::string& text) {
    return text.size() == 7 && text[0] == '#' &&
           text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
}

void check_size(const char* what, Eigen::Index given, Index polygons) {
    if (given != 0 && given != polygons)
        throw InvalidInput(fmt::format("{} {} are given: expected one for each of the {} polygons, "
                                       "or none",
                                       given, what, polygons));
}

void check_faces(const SolidFaces& faces) {
    check_polygons(faces.polygons);
    const Index polygons = faces.polygons.size();
    if (polygons == 0)
        throw InvalidInput("there are no polygons to draw: add one");
    if (faces.polygons.points.cols() != 3)
        throw InvalidInput(fmt::format("the polygons have {} coordinates a point: expected three",
                                       faces.polygons.points.cols()));
    check_size("values", faces.values.size(), polygons);
    check_size("fills", static_cast<Eigen::Index>(faces.fills.size()), polygons);
    check_size("depth sites", faces.depth_sites.rows(), polygons);
    if (faces.depth_sites.rows() > 0 && faces.depth_sites.cols() != 3)
        throw InvalidInput(fmt::format("the depth sites have {} coordinates: expected three",
                                       faces.depth_sites.cols()));
    for (Index f = 0; f < polygons; ++f) {
        const auto complain = [f](const char* what) {
            throw InvalidInput(fmt::format("polygon {} has {}", f, what),
                               {.degree = 2, .cells = {f}});
        };
        if (faces.polygons.face(f).size() < 3)
            complain("fewer than three corners: leave it out");
        if (!mean_of(faces.polygons, f).allFinite() ||
            (faces.depth_sites.rows() > 0 && !faces.depth_sites.row(f).allFinite()))
            complain("a coordinate that is NaN or infinite: correct it");
        if (faces.values.size() > 0 && !std::isfinite(faces.values[f]))
            complain("a value that is NaN or infinite: correct it");
        if (!faces.fills.empty() && !faces.fills[f].empty() && !is_color(faces.fills[f]))
            complain("a fill that is not a color: expected \"#rrggbb\", or \"\" for the color of "
                     "its value");
    }
}

std::vector<Index> order_of(const SolidFaces& faces, const Frame& frame) {
    std::vector<Index> order;
    Vector depth(faces.polygons.size());
    for (Index f = 0; f < faces.polygons.size(); ++f) {
        const Place site = faces.depth_sites.rows() > 0 ? Place(faces.depth_sites.row(f))
                                                        : mean_of(faces.polygons, f);
        depth[f] = frame.eye.dot(site);
        if (!faces.closed || frame.eye.dot(normal_of(faces.polygons, f)) > 0)
            order.push_back(f);
    }
    std::stable_sort(order.begin(), order.end(),
                     [&](Index a, Index b) { return depth[a] < depth[b]; });
    return order;
}

/// The colors of values, as far as the view does not choose them.
ColorRange colors_of(const Vector& values, const SolidView& view) {
    const double low = values.minCoeff(), high = values.maxCoeff();
    const ColorMap map = view.map.value_or(color_range(low, high).map);
    const double most = std::max(-low, high);
    const auto [begin, end] = view.range.value_or(map == ColorMap::diverging ? SvgPoint{-most, most}
                                                                             : SvgPoint{low, high});
    if (!std::isfinite(begin) || !std::isfinite(end) || begin > end)
        throw InvalidInput(fmt::format("the view's range {} .. {} must be two finite numbers "
                                       "in ascending order",
                                       begin, end));
    return {map, begin, end, begin == end};
}

/// A bar with the colors below what is drawn, its ends in words beside it.
void add_legend(SvgDrawing& drawing, const ColorRange& scale) {
    constexpr int pieces = 64;
    const SvgExtent extent = extent_of_polygons(drawing);
    const double pixel = extent.size(0) / (drawing.width - 2 * drawing.margin);
    const double width = 0.4 * extent.size(0),
                 left = 0.5 * (extent.low[0] + extent.high[0] - width);
    const double top = extent.low[1] - 18 * pixel, bottom = top - 12 * pixel;
    for (int i = 0; i < pieces; ++i) {
        const double x = left + width * i / pieces, next = left + width * (i + 1) / pieces;
        const std::string color = color_at(scale.map, (i + 0.5) / pieces);
        drawing.shapes.push_back(SvgPolygon{{{x, bottom}, {next, bottom}, {next, top}, {x, top}},
                                            {.stroke = color, .fill = color, .width = 0.5}});
    }
    const auto add_number = [&](double x, double value, SvgAnchor anchor) {
        const std::string text = fmt::format("{:.3g}", value);
        drawing.shapes.push_back(SvgText{{x, bottom + 1.5 * pixel}, text, 13, anchor, "#333333"});
    };
    const double space = 8 * pixel;
    add_number(left - space, scale.low, SvgAnchor::end);
    add_number(left + width + space, scale.high, SvgAnchor::start);
}

/// The cells of a solid that are kept, with what all their faces have in common.
class Kept {
public:
    Kept(const Discretization& given, const std::function<bool(const Vector&)>& keep,
         const Vector& values)
        : mesh_(placed(given)), values_(values) {
        check_callable("the predicate of kept cells", keep);
        const Index n_cells = given.complex().size(3);
        require_points(mesh_.points().cols(), "a drawing");
        if (mesh_.dimension() != 3 || mesh_.points().cols() != 3)
            throw InvalidInput(fmt::format(
                "cells of dimension {} in {} coordinates are not a solid: expected 3 and 3",
                mesh_.dimension(), mesh_.points().cols()));
        if (values.size() != 0 && values.size() != n_cells)
            throw InvalidInput(fmt::format(
                "{} values are given: expected one for each of the {} merged 3-cells, or none",
                values.size(), n_cells));
        numbers_ = cells_of_places(given, 3);
        centroids_ = cell_centroids(mesh_, 3);
        // cells on one sphere share a center; their centroids tell which is nearer
        centers_ = cell_centers(mesh_, 3);
        centers_ += 1e-6 * (centroids_ - centers_);
        for (Index cell = 0; cell < mesh_.complex().size(3); ++cell)
            if (keep(centroids_.row(cell).transpose()))
                cells_.push_back(cell);
        if (cells_.empty())
            throw InvalidInput("no cell is kept: 'keep' must be true for at least one centroid");
    }

    const std::vector<Index>& cells() const { return cells_; }
    Place centroid(Index cell) const { return centroids_.row(cell); }

    /// How many kept cells are on each 2-cell.
    std::vector<int> cell_counts() const {
        std::vector<int> counts(mesh_.complex().size(2), 0);
        for (const Index cell : cells_)
            for (const SignedFace& f : mesh_.complex().incidences(2)[cell])
                ++counts[f.face];
        return counts;
    }

    /// The corners of a cell's face, counterclockwise from outside.
    std::vector<Index> outward(Index cell, Index face) const {
        const auto ring = corners(mesh_.merging(), face);
        const Place out = mean_of(mesh_.points(), ring) - centroid(cell);
        const bool turned = normal_of(mesh_.points(), ring).dot(out) < 0;
        return turned ? std::vector<Index>(ring.rbegin(), ring.rend()) : ring;
    }

    /// Values and depth of the polygons, whose cells are known.
    void finish(SolidFaces& faces) const {
        faces.closed = true;
        faces.depth_sites = centers_(faces.cells, Eigen::indexing::all);
        for (Index& cell : faces.cells)
            cell = numbers_[cell];
        if (values_.size() > 0)
            faces.values = values_(faces.cells);
    }

private:
    const Discretization& mesh_;
    const Vector& values_;
    std::vector<Index> numbers_; // of the cells that are drawn, in the mesh that is given
    Points centroids_, centers_;
    std::vector<Index> cells_;
};

void add_polygon(SolidFaces& faces, const std::vector<Index>& corners, Index cell) {
    faces.polygons.add(corners);
    faces.cells.push_back(cell);
}

} // namespace

SolidFaces kept_faces(const Discretization& given,
                      const std::function<bool(const Vector& centroid)>& keep,
                      const Vector& values) {
    const Kept kept(given, keep, values);
    const Discretization& mesh = placed(given);
    const auto counts = kept.cell_counts();
    SolidFaces faces;
    faces.polygons.points = mesh.points();
    for (const Index cell : kept.cells())
        for (const SignedFace& f : mesh.complex().incidences(2)[cell])
            if (counts[f.face] == 1)
                add_polygon(faces, kept.outward(cell, f.face), cell);
    kept.finish(faces);
    return faces;
}

SolidFaces kept_cells(const Discretization& given,
                      const std::function<bool(const Vector& centroid)>& keep, double gap,
                      const Vector& values) {
    if (!(gap >= 0 && gap < 1))
        throw InvalidInput(fmt::format("the gap {} between cells is outside of 0 <= gap < 1", gap));
    const Kept kept(given, keep, values);
    const Discretization& mesh = placed(given);
    SolidFaces faces;
    std::vector<Place> points; // each face has its own corners
    for (const Index cell : kept.cells())
        for (const SignedFace& f : mesh.complex().incidences(2)[cell]) {
            auto ring = kept.outward(cell, f.face);
            for (Index& v : ring) {
                const Place corner = mesh.points().row(v);
                v = static_cast<Index>(points.size());
                points.push_back(corner + gap * (kept.centroid(cell) - corner));
            }
            add_polygon(faces, ring, cell);
        }
    faces.polygons.points.resize(static_cast<Eigen::Index>(points.size()), 3);
    for (std::size_t i = 0; i < points.size(); ++i)
        faces.polygons.points.row(static_cast<Eigen::Index>(i)) = points[i];
    kept.finish(faces);
    return faces;
}

SvgPoint seen_at(const SolidView& view, const Vector& point) {
    if (point.size() != 3 || !point.allFinite())
        throw InvalidInput("a point to view must have three finite coordinates");
    return Frame(view)(point);
}

std::vector<Index> painting_order(const SolidFaces& faces, const SolidView& view) {
    check_faces(faces);
    return order_of(faces, Frame(view));
}

SvgDrawing draw_solid(const SolidFaces& faces, const SolidView& view) {
    check_faces(faces);
    const Frame frame(view);
    if (!is_color(view.plain))
        throw InvalidInput("the view's plain color must be \"#rrggbb\"");
    std::optional<ColorRange> scale;
    if (faces.values.size() > 0)
        scale = colors_of(faces.values, view);

    SvgDrawing drawing{.title = view.title, .width = view.width};
    for (const Index f : order_of(faces, frame)) {
        std::string fill = scale ? color_at(scale->map, scale->part(faces.values[f])) : view.plain;
        if (!faces.fills.empty() && !faces.fills[f].empty())
            fill = faces.fills[f];
        fill = color_text(
            darker(color_of(fill), brightness(frame.parts(normal_of(faces.polygons, f)))));
        // without lines a thin one of the same color closes the seams
        SvgPolygon polygon{{}, {.stroke = fill, .fill = fill, .width = 0.4}};
        if (view.line != "none")
            polygon.style = {.stroke = view.line, .fill = fill, .width = view.line_width};
        for (const Index v : faces.polygons.face(f))
            polygon.points.push_back(frame(faces.polygons.points.row(v)));
        drawing.shapes.push_back(std::move(polygon));
    }
    if (scale && view.legend && !drawing.shapes.empty())
        add_legend(drawing, *scale);
    return drawing;
}

} // namespace polydec
