// SPDX-License-Identifier: MIT
#include "io/pages/page_content.h"

#include "io/meshes/mesh_files.h"
#include "io/pages/projection.h"
#include "io/pages/surface_painter.h"
#include "io/pictures/draw_cells.h"
#include "io/pictures/upright_view.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace polydec {

namespace {

using Place = Eigen::Vector3d;

/// Seen after a quarter of a turn.
SolidView turned(SolidView view) {
    const Place up = view.up, eye = view.eye;
    view.eye = up.dot(eye) * up + up.cross(eye);
    return view;
}

SolidView from_below(SolidView view) {
    const Place up = view.up, eye = view.eye;
    view.eye = eye - 2 * up.dot(eye) * up;
    return view;
}

/// Of the cells, the means of the corners of their triangles, by their height over the cut's side.
Vector heights_of_cells(const PageFaces& faces, const Points& points, int side) {
    const Vector along = points.col(side % 3) * (side < 3 ? 1 : -1);
    Vector sums = Vector::Zero(faces.count_cells()), counts = sums;
    for (Index t = 0; t < faces.size(); ++t)
        for (const Index cell : faces.owners[t])
            if (cell >= 0)
                for (int i = 0; i < 3; ++i) {
                    sums[cell] += along[faces.corners[3 * t + i]];
                    ++counts[cell];
                }
    return sums.cwiseQuotient(counts.cwiseMax(1));
}

class Opener {
public:
    static constexpr double nearly = 0.95;  // as large as the largest
    static constexpr double clearly = 1.25; // wider: a quarter is seen, and is no error of rounding

    explicit Opener(const PageContent& content)
        : page_(content.page),
          points_(content.points),
          faces_(content.faces),
          shown_(content.shown),
          numbers_(shown_numbers(shown_.at(content.page, shown_.step)).cwiseAbs()) {
        for (const double number : numbers_)
            if (number > largest_)
                largest_ = number; // not NaN
    }

    bool has_numbers() const { return largest_ > 0 && std::isfinite(largest_); }

    bool has_paths() const {
        return std::any_of(page_.arrows.begin(), page_.arrows.end(),
                           [](const PageArrows& arrows) { return arrows.is_path(); });
    }

    /// How many places are seen on paths or, without any, where the field has this part of its
    /// largest value.
    std::ptrdiff_t count_seen(const SolidView& view, const PageFaces& surface, double part) const {
        constexpr int width = 320, height = 200;
        const Projection project(view, points_, surface.corners, {0, 0, width, height});
        SurfacePainter painter(width, height, {}, {});
        SeenTriangle seen;
        std::vector<Place> places;
        for (Index t = 0; t < surface.size(); ++t) {
            Place middle = Place::Zero();
            for (std::size_t i = 0; i < 3; ++i) {
                const Index corner = 3 * t + static_cast<Index>(i);
                seen.corners[i] = project(points_, surface.corners[corner]);
                middle += seen.corners[i] / 3;
            }
            painter.paint(seen);
            for (std::size_t i = 0; i < 3 && !has_paths(); ++i)
                if (is_large(surface.entry(shown_.place, 3 * t + static_cast<Index>(i)), part))
                    places.push_back(shown_.place == "vertex" ? seen.corners[i]
                                     : shown_.place == "edge"
                                         ? Place((seen.corners[i] + seen.corners[(i + 1) % 3]) / 2)
                                         : middle);
        }
        for (const PageArrows& arrows : page_.arrows) {
            const Mesh& lines = arrows.lines;
            const Points ends = in_space(lines.points);
            for (Index i = 0; i < lines.simplices.rows() && arrows.is_path(); ++i)
                places.push_back(project(Place(
                    (ends.row(lines.simplices(i, 0)) + ends.row(lines.simplices(i, 1))) / 2)));
        }
        return std::count_if(places.begin(), places.end(),
                             [&](const Place& place) { return painter.shows(place); });
    }

    /// The percentage where a cell with a large number is the last one that is kept.
    int percent_of_largest(int side) const {
        const Vector heights = heights_of_cells(faces_, points_, side);
        double least = heights.maxCoeff();
        for (Index corner = 0; corner < 3 * faces_.size(); ++corner)
            for (const Index cell : faces_.owners[corner / 3])
                if (cell >= 0 &&
                    is_large(shown_.place == "cell" ? cell : faces_.entry(shown_.place, corner)))
                    least = std::min(least, heights[cell]);
        const double part =
            (least - heights.minCoeff()) / (heights.maxCoeff() - heights.minCoeff());
        return part < 1 ? static_cast<int>(std::ceil(100 * part)) : 100;
    }

    /// Of views from all sides, the first that shows most of the paths or the field's largest
    /// value, or else one that is nearly as large; from below if none from above does. Nothing:
    /// none does.
    std::optional<SolidView> view_around(const SolidView& front) const {
        const PageFaces whole = faces_.visible(std::vector(faces_.count_cells(), true));
        std::optional<SolidView> best;
        std::ptrdiff_t most = 0;
        for (const SolidView& first : {front, from_below(front)})
            for (const double part : {1.0, nearly}) {
                SolidView view = first;
                for (int turns = 0; turns < 4 && (most == 0 || has_paths()); ++turns) {
                    if (const auto seen = count_seen(view, whole, part); seen > most) {
                        best = view;
                        most = seen;
                    }
                    view = turned(view);
                }
                if (best)
                    return best;
            }
        return best;
    }

    struct Cut {
        Opening opening;
        bool shows_largest;
        double area; ///< opened, as the eye sees it
    };

    /// A cut in half across an axis, towards the eye, or, if the field's largest value is not seen
    /// there, through it; of a field with vectors always in the middle part, where the section is
    /// wide enough for arrows.
    Cut cut(Opening opening, int axis) const {
        opening.side = opening.view.eye[axis] < 0 ? axis + 3 : axis;
        opening.percent = 50;
        bool shows_largest = sees_largest(opening);
        if (!shows_largest) {
            opening.percent = percent_of_largest(opening.side);
            if (shown_.has_vectors())
                opening.percent = std::clamp(opening.percent, 30, 70);
            shows_largest = sees_largest(opening);
        }
        return {opening, shows_largest, area_opened_by(opening)};
    }

private:
    bool sees_largest(const Opening& opening) const {
        return count_seen(opening.view, faces_.visible(opening.kept(faces_, points_)), nearly) > 0;
    }

    /// How much of the faces that only a cut shows the eye sees.
    double area_opened_by(const Opening& cut) const {
        const auto kept = cut.kept(faces_, points_);
        const auto corner = [&](Index i) { return Place(points_.row(faces_.corners[i])); };
        double sum = 0;
        for (Index t = 0; t < faces_.size(); ++t) {
            const auto [cell, other] = faces_.owners[t];
            if (cell < 0 || other < 0 || kept[cell] == kept[other])
                continue;
            const Place p = corner(3 * t), q = corner(3 * t + 1) - p, r = corner(3 * t + 2) - p;
            sum += std::abs(q.cross(r).dot(Place(cut.view.eye))) / 2;
        }
        return sum;
    }

    bool is_large(Index entry, double part = nearly) const {
        return entry >= 0 && numbers_[entry] >= part * largest_;
    }

    const Page& page_;
    const Points& points_;
    const PageFaces& faces_;
    const ShownField& shown_;
    Vector numbers_;
    double largest_ = 0;
};

/// Of content whose fields are known.
Opening opening_of(const PageContent& content) {
    const Points& points = content.points;
    const PageFaces& faces = content.faces;
    const int up = upward_axis(content.page);
    Opening opening{first_view(points, up)};
    if (content.shown.field == nullptr || faces.dimension < 2 || is_flat(points))
        return opening;
    const bool is_solid = faces.dimension > 2;
    opening.side = up == 1 ? 2 : 4;
    const Opener opener(content);
    if (!opener.has_numbers())
        return opening;
    if (!is_solid || !content.shown.has_vectors()) { // vectors of solids are inside, most of them
        const auto view = opener.view_around(opening.view);
        if (view)
            opening.view = *view;
        if (view || !is_solid)
            return opening;
    }
    Opener::Cut best = opener.cut(opening, opening.side % 3);
    for (const int turn : {1, 2}) {
        const auto other = opener.cut(opening, (opening.side + turn) % 3);
        if (other.shows_largest >= best.shows_largest && other.area > Opener::clearly * best.area)
            best = other;
    }
    return best.opening;
}

} // namespace

int upward_axis(const Page& page) {
    const int axis = page.text.up.value_or(up_axis(page.text.file));
    upright_view(axis); // throws for other axes
    return axis;
}

Points in_space(const Points& points) {
    Points result = Points::Zero(points.rows(), 3);
    result.leftCols(points.cols()) = points;
    return result;
}

std::vector<bool> Opening::kept(const PageFaces& faces, const Points& points) const {
    std::vector<bool> result(faces.count_cells(), true);
    if (percent >= 100)
        return result;
    const Vector heights = heights_of_cells(faces, points, side);
    const double low = heights.minCoeff(), high = heights.maxCoeff();
    const double limit = low + (high - low) * (percent / 100.0 + 1e-6);
    for (Index cell = 0; cell < heights.size(); ++cell)
        result[cell] = heights[cell] <= limit;
    return result;
}

PageContent::PageContent(const Page& content) : page(content), points(in_space(page.grid.points)) {
    check_grid("a page", page.grid);
    const auto take = [&](PageFaces drawn, const CellComplex* complex) {
        faces = std::move(drawn);
        fields = page_fields(page, faces.dimension, complex);
    };
    if (page.mesh) {
        const Merging cells = drawn_cells(*page.mesh);
        take(page_faces(cells), &cells.merged());
    } else {
        take(page_faces(page.grid, page.groups), nullptr);
    }
    shown = shown_field(page, fields, faces.count_cells());
    opening = opening_of(*this);
}

} // namespace polydec
