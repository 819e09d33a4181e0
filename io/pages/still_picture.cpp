// SPDX-License-Identifier: MIT
#include "io/pages/still_picture.h"

#include "io/pages/first_view.h"
#include "io/pages/page_fields.h"
#include "io/pictures/draw_solid.h"
#include "io/pictures/svg_drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

namespace polydec {

namespace {

constexpr Index most_polygons = 3000;
constexpr int raster = 26; ///< places to a side for coarse pictures

using Spot = std::array<int, 3>;

/// Values of polygons, from those of their corners or of the cells behind them.
class PolygonValues {
public:
    PolygonValues(const VtuGrid& grid, const VtuArray* shown) {
        if (shown != nullptr)
            numbers_ = shown_numbers(*shown);
        for (const auto& array : grid.point_data)
            at_points_ = at_points_ || &array == shown;
    }

    bool exist() const { return numbers_.has_value(); }
    double of(std::span<const Index> corners, Index cell) const {
        if (!at_points_)
            return (*numbers_)[cell];
        double sum = 0;
        for (const Index v : corners)
            sum += (*numbers_)[v] / static_cast<double>(corners.size());
        return sum;
    }

private:
    std::optional<Vector> numbers_;
    bool at_points_ = false;
};

/// Points of the picture: three coordinates around 0, of size 1 at most.
Points pictured(const Points& points) {
    Points result = Points::Zero(points.rows(), 3);
    if (points.rows() == 0)
        return result;
    const Eigen::RowVectorXd low = points.colwise().minCoeff(), high = points.colwise().maxCoeff();
    const double size = (high / 2 - low / 2).maxCoeff();
    for (Eigen::Index v = 0; v < points.rows() && size > 0; ++v)
        result.row(v).head(points.cols()) =
            points.row(v) / size - (low / size / 2 + high / size / 2);
    return result;
}

void add_polygon(SolidFaces& picture, std::span<const Index> corners, Index cell) {
    auto& polygons = picture.polygons;
    polygons.corners.insert(polygons.corners.end(), corners.begin(), corners.end());
    polygons.offsets.push_back(static_cast<Index>(polygons.corners.size()));
    picture.cells.push_back(cell);
}

void add_values(SolidFaces& picture, const std::vector<double>& values) {
    picture.values =
        Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// Every polygon of the surface.
SolidFaces fine(const Points& points, const PageRings& rings, const PolygonValues& values) {
    SolidFaces picture;
    picture.polygons.points = points;
    std::vector<double> numbers;
    for (std::size_t ring = 0; ring < rings.owners.size(); ++ring) {
        const auto [cell, other] = rings.owners[ring];
        if (other >= 0)
            continue;
        const std::span corners(rings.corners.data() + rings.offsets[ring],
                                rings.corners.data() + rings.offsets[ring + 1]);
        add_polygon(picture, corners, cell);
        if (values.exist())
            numbers.push_back(values.of(corners, cell));
    }
    add_values(picture, numbers);
    return picture;
}

/// Vertices that fall into one place of a raster become one, and triangles that vanish are left
/// out.
SolidFaces coarse(const Points& points, const PageFaces& faces, const PolygonValues& values) {
    std::map<Spot, Index> numbers;
    std::vector<Index> spot_of(static_cast<std::size_t>(points.rows()));
    std::vector<Eigen::Vector4d> sums; // and how many
    for (Eigen::Index v = 0; v < points.rows(); ++v) {
        Spot spot;
        for (int axis = 0; axis < 3; ++axis)
            spot[axis] = static_cast<int>(std::floor((points(v, axis) + 1) / 2 * raster));
        const auto [place, is_new] = numbers.try_emplace(spot, static_cast<Index>(sums.size()));
        if (is_new)
            sums.emplace_back(Eigen::Vector4d::Zero());
        sums[place->second] += Eigen::Vector4d(points(v, 0), points(v, 1), points(v, 2), 1);
        spot_of[v] = place->second;
    }
    SolidFaces picture;
    picture.polygons.points.resize(static_cast<Eigen::Index>(sums.size()), 3);
    for (std::size_t i = 0; i < sums.size(); ++i)
        picture.polygons.points.row(static_cast<Eigen::Index>(i)) =
            (sums[i].head(3) / sums[i][3]).transpose();

    std::set<std::array<Index, 3>> known;
    std::vector<double> shown;
    for (Index t = 0; t < faces.size(); ++t) {
        const std::span corners(&faces.corners[3 * t], 3);
        std::array<Index, 3> spots{spot_of[corners[0]], spot_of[corners[1]], spot_of[corners[2]]};
        auto sorted = spots;
        std::sort(sorted.begin(), sorted.end());
        if (faces.owners[t][1] >= 0 || sorted[0] == sorted[1] || sorted[1] == sorted[2] ||
            !known.insert(sorted).second)
            continue;
        add_polygon(picture, spots, faces.owners[t][0]);
        if (values.exist())
            shown.push_back(values.of(corners, faces.owners[t][0]));
    }
    add_values(picture, shown);
    return picture;
}

std::string curve(const Points& points, const PageFaces& faces, const SolidView& view) {
    SvgDrawing drawing;
    const Index size = faces.size(), stride = 1 + size / most_polygons;
    for (Index line = 0; line < size; line += stride) {
        SvgPolyline shape;
        for (const int end : {0, 1})
            shape.points.push_back(
                seen_at(view, points.row(faces.lines[2 * line + end]).transpose()));
        drawing.shapes.emplace_back(std::move(shape));
    }
    return to_svg(drawing);
}

} // namespace

std::string still_picture(const VtuGrid& grid, const PageFaces& faces, const VtuArray* shown,
                          int up) {
    const Points points = pictured(grid.points);
    if (faces.size() == 0 || points.maxCoeff() == points.minCoeff())
        return "";
    SolidView view = first_view(points, up);
    if (faces.dimension < 2)
        return curve(points, faces, view);
    const PolygonValues values(grid, shown);
    const auto on_surface = std::count_if(faces.owners.begin(), faces.owners.end(),
                                          [](const auto& both) { return both[1] < 0; });
    if (on_surface <= most_polygons)
        return to_svg(draw_solid(fine(points, page_rings(grid), values), view));
    view.line = "none";
    return to_svg(draw_solid(coarse(points, faces, values), view));
}

} // namespace polydec
