// SPDX-License-Identifier: MIT
#include "io/pictures/draw_structure.h"

#include "base/errors.h"
#include "complex/merging.h"
#include "dec/discretization/cell_data.h"
#include "dec/discretization/glued_box.h"
#include "dec/fields/cell_centers.h"
#include "dec/metric/rounding.h"
#include "io/pictures/draw_cells.h"
#include "io/pictures/structure_drawing.h"
#include "io/pictures/upright_view.h"

#include <Eigen/Geometry>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace polydec {

namespace {

constexpr double legible = 9; // least size of numbers, pixels

} // namespace

StructureDrawing::StructureDrawing(const Discretization& given, const StructureOptions& options)
    : mesh_(placed(given)),
      n_(mesh_.dimension()),
      points_(mesh_.measured_points()),
      options_(options),
      view_(options.view),
      is_plane_(is_flat(points_)) {
    if (n_ > 2 || points_.cols() < n_ || points_.cols() > 3)
        throw InvalidInput(
            fmt::format("cells of dimension {} in {} coordinates: a drawing of the structure shows "
                        "edges or polygons in at most three coordinates; a page shows solids",
                        n_, points_.cols()));
    if (!mesh_.passage().is_identity())
        throw InvalidInput(
            "flipped edges are not straight lines: draw the mesh without flips, or as a page");
    if (is_plane_) {
        view_.eye = Point(0, 0, 1);
        view_.up = Point(0, 1, 0);
    }
    options_.duals = options.duals || options.dual_orientations || options.centroids;
    for (int k = 0; k <= n_; ++k) {
        numbers_[k] = cells_of_places(given, k);
        centers_[k] =
            (options.centroids ? cell_centroids(mesh_, k) : cell_centers(mesh_, k)) / mesh_.unit();
    }
    corners_.resize(mesh_.complex().size(n_));
    removed_.resize(corners_.size());
    ends_in_cell_.resize(mesh_.complex().size(n_ - 1));
    for (Index cell = 0; cell < std::ssize(corners_); ++cell) {
        const auto [a, b] = n_ == 1 ? ends(cell) : std::pair<Index, Index>();
        corners_[cell] = n_ == 1 ? std::vector{a, b} : corners(mesh_.merging(), cell);
        for (const auto& [facet, sign] : mesh_.complex().incidences(n_ - 1)[cell])
            ends_in_cell_[facet] = ends_in_cell_[facet] || is_end_of_dual(sign);
    }
    const auto& carriers = mesh_.merging().carriers(n_ - 1);
    for (Index facet = 0; facet < std::ssize(carriers); ++facet)
        if (carriers[facet].dimension == n_)
            removed_[carriers[facet].cell].push_back(facet);
    fill_dual(given);
}

/// The rings of the dual cell; those of each place of a vertex on a seam.
void StructureDrawing::fill_dual(const Discretization& given) {
    if (!options_.cell)
        return;
    const Index vertex = cells_of_vertices(given, "the dual cell of", {*options_.cell}).front();
    for (Index v = 0; v < std::ssize(numbers_[0]); ++v)
        if (numbers_[0][v] == vertex)
            for (auto& ring : dual_rings(mesh_, v))
                rings_.push_back(std::move(ring));
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
    for (Index v = 0; v < mesh_.complex().size(0); ++v)
        extent_.add(seen(at(points_, v)));
    for (Index cell = 0; cell < mesh_.complex().size(n_); ++cell) {
        const Point center = at(centers_[n_], cell);
        if (options_.circumcircles)
            extent_.add(seen(center), (at(points_, corners_[cell].front()) - center).norm());
        else if (options_.duals)
            extent_.add(seen(center));
    }
    for (const auto& ring : rings_)
        for (const auto& [degree, cell] : ring)
            extent_.add(seen(at(centers_[degree], cell)));
}

/// Numbers are as large as the edges between them allow.
void StructureDrawing::choose_text_size(std::size_t rows_of_words) {
    const double inside = drawing_.width - 2 * drawing_.margin;
    const double legend = rows_of_words == 0 ? 0 : height_of_lines(rows_of_words);
    pixel_ =
        std::max(extent_.size(0) / inside, extent_.size(1) / std::max(inside, 2 * inside - legend));
    const double fitting = middling_edge() / pixel_ / 5;
    text_size_ = std::clamp(fitting, legible, 15.0);
    if (options_.numbers && fitting < legible)
        throw InvalidInput(fmt::format("{} edges are too many for legible numbers in a drawing {} "
                                       "pixels wide: draw it {:.0f} wide, or without numbers",
                                       mesh_.complex().size(1), drawing_.width,
                                       std::ceil(drawing_.width * legible / fitting)));
}

/// Whether every edge has two cells, which look outward.
bool StructureDrawing::is_closed() const {
    if (!mesh_.pieces().orientable())
        return false;
    std::vector<int> sides(mesh_.complex().size(1), 0);
    double volume = 0;
    for (Index cell = 0; cell < mesh_.complex().size(n_); ++cell) {
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
bool StructureDrawing::is_negative(Index facet) const {
    const double length = mesh_.volumes().dual(n_ - 1)[facet];
    return !options_.centroids && length < 0 &&
           !is_zero(length, mesh_.volumes().terms(n_ - 1)[facet]);
}

bool StructureDrawing::is_end_of_dual(int sign) const {
    return n_ % 2 == 0 ? sign > 0 : sign < 0;
}

/// Cells that do not hide each other, from far to near.
std::vector<std::vector<Index>> StructureDrawing::layers() const {
    std::vector<Index> all(corners_.size());
    std::iota(all.begin(), all.end(), 0);
    if (is_plane_ || n_ == 1)
        return {all};
    SolidFaces faces{.polygons = polygon_mesh(mesh_.merging(), points_)};
    faces.closed = is_closed();
    std::vector<std::vector<Index>> result;
    for (const Index cell : painting_order(faces, view_))
        result.push_back({cell});
    return result;
}

/// The nearest layer with cells around the vertex whose dual is filled; -1 if there is none.
std::ptrdiff_t
StructureDrawing::layer_to_fill(const std::vector<std::vector<Index>>& layers) const {
    std::vector<std::ptrdiff_t> of_cell(corners_.size(), -1);
    for (std::ptrdiff_t i = 0; i < std::ssize(layers); ++i)
        for (const Index cell : layers[i])
            of_cell[cell] = i;
    std::ptrdiff_t nearest = -1;
    for (const auto& ring : rings_)
        for (const auto& [degree, cell] : ring) {
            if (degree != n_)
                continue;
            if (of_cell[cell] < 0)
                throw InvalidInput(fmt::format(
                    "the dual cell of vertex {} is turned away in part: look from another side",
                    *options_.cell));
            nearest = std::max(nearest, of_cell[cell]);
        }
    return nearest;
}

/// What the kinds of lines and numbers are.
std::vector<LineInWords> StructureDrawing::words() const {
    std::vector<LineInWords> rows;
    if (n_ == 1)
        rows.push_back({chain_style(), "edges, dots: vertices"});
    else
        rows.push_back({edge_style(), "edges of the cells"});
    if (std::any_of(removed_.begin(), removed_.end(),
                    [](const auto& edges) { return !edges.empty(); }))
        rows.push_back({removed_style(), "edges merged away: their duals have no length"});
    if (options_.duals)
        rows.push_back({dual_style(), options_.centroids ? "dual edges, dots: centroids of cells"
                                                         : "dual edges, dots: centers of cells"});
    bool any_negative = false;
    for (Index facet = 0; facet < mesh_.complex().size(n_ - 1); ++facet)
        any_negative = any_negative || is_negative(facet);
    if (options_.duals && any_negative)
        rows.push_back({negative_style(), "dual edges of negative length"});
    if (options_.dual_orientations)
        rows.push_back({{.stroke = "none"}, "heads on dual edges: their orientations"});
    if (options_.cell)
        rows.push_back({n_ == 1 ? band_style() : fill_style(),
                        fmt::format("dual cell of vertex {}", *options_.cell)});
    if (options_.circumcircles)
        rows.push_back({circle_style(), "circumcircles of the cells"});
    if (options_.orientations)
        rows.push_back({n_ == 1 ? SvgStyle{.stroke = "none"} : turn_style(),
                        n_ == 1 ? "heads on edges: their orientations"
                                : "orientations: heads on edges, arcs in cells"});
    if (options_.numbers)
        rows.push_back({{.stroke = "none"},
                        n_ == 1 ? "numbers of vertices (black), edges (orange)"
                                : "numbers of vertices (black), edges (orange), cells (purple)"});
    return rows;
}

SvgDrawing StructureDrawing::draw() {
    drawing_.title = view_.title;
    drawing_.width = view_.width;
    drawing_.margin = 24;
    find_extent();
    const auto rows = options_.words ? words() : std::vector<LineInWords>();
    choose_text_size(rows.size());
    const auto order = layers();
    const std::ptrdiff_t filled_layer = layer_to_fill(order);
    for (std::ptrdiff_t i = 0; i < std::ssize(order); ++i) {
        std::vector<Strokes> all;
        std::vector<SvgShape> grounds, fill = i == filled_layer ? filled() : grounds;
        for (const Index cell : order[i]) {
            grounds.push_back(ground(cell));
            all.push_back(strokes(cell));
        }
        if (n_ == 1)
            std::swap(grounds, fill);
        append(grounds);
        append(fill);
        for (const auto part : {&Strokes::lines, &Strokes::marks})
            for (auto& own : all)
                append(own.*part);
    }
    if (options_.numbers)
        add_numbers(order);
    if (options_.words)
        tell_lines(drawing_, rows, extent_.low, pixel_);
    return std::move(drawing_);
}

SvgDrawing draw_structure(const Discretization& mesh, const StructureOptions& options) {
    return StructureDrawing(mesh, options).draw();
}

} // namespace polydec
