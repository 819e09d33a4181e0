// SPDX-License-Identifier: MIT
#include "io/pages/still_scene.h"

#include "base/errors.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace polydec {

namespace {

Points in_space(const Points& points) {
    Points result = Points::Zero(points.rows(), 3);
    result.leftCols(points.cols()) = points;
    return result;
}

} // namespace

StillScenes::StillScenes(const Page& page) : page_(page), points_(in_space(page.grid.points)) {
    check_grid("a picture", page.grid);
    auto [faces, fields] = page_content(page);
    fields_ = std::move(fields);
    if (faces.size() == 0)
        throw InvalidInput("a picture needs lines or faces, and this page has only points: write a "
                           ".vtu file");
    add_visible(faces);
    first_ = first_field(page, fields_);
    if (first_ == nullptr)
        return;
    place_ = first_->place;
    find_strengths();
    const auto [low, high] = strengths_.empty() ? range_of(page, *first_) : range_of(strengths_);
    range_ = color_range(low, high);
}

void StillScenes::add_visible(const PageFaces& faces) {
    corners_of_cell_ = faces.dimension < 2 ? 2 : 3;
    for (Index t = 0; t < faces.size(); ++t) {
        for (const Index cell : faces.owners[t])
            cells_ = std::max(cells_, static_cast<std::size_t>(cell + 1));
        if (faces.owners[t][1] >= 0)
            continue; // inside a solid
        owners_.push_back(faces.owners[t][0]);
        const auto& list = is_curve() ? faces.lines : faces.corners;
        for (int i = 0; i < corners_of_cell_; ++i)
            corners_.push_back(list[corners_of_cell_ * t + i]);
        if (is_curve())
            continue;
        sides_.push_back(faces.sides[t]);
        if (!faces.faces.empty())
            faces_.push_back(faces.faces[t]);
        for (int i = 0; i < 3 && !faces.edges.empty(); ++i)
            edges_.push_back(faces.edges[3 * t + i]);
    }
}

/// Of the arrows that come with the first field, if cells have them.
void StillScenes::find_strengths() {
    for (std::size_t i = 0; i < page_.arrows.size() && strengths_.empty(); ++i)
        if (page_.arrows[i].field == first_->array->name && !is_curve()) {
            const auto count = static_cast<std::ptrdiff_t>(cells_);
            strengths_ = strengths(page_, fields_, page_.arrows[i], count);
            vectors_ = vectors_of_cells(page_, fields_, page_.arrows[i], count);
        }
    if (!strengths_.empty())
        place_ = "cell";
}

std::string StillScenes::name() const {
    return strengths_.empty() ? first_->array->name : strengths_.front().name;
}

const VtuArray& StillScenes::array_at(std::size_t step) const {
    if (!strengths_.empty())
        return strengths_[step];
    return page_.steps.empty() ? *first_->array : first_->at(page_.steps[step]);
}

/// The vectors whose lengths are shown, one for each value; or none.
Points StillScenes::vectors_at(std::size_t step) const {
    if (!strengths_.empty())
        return in_space(vectors_[step]);
    const VtuArray& array = array_at(step);
    return array.components == 3 ? Points(rows_of(array)) : Points(0, 3);
}

/// At the corners; of fields on edges, on the sides from the corners to the next.
std::vector<double> StillScenes::values_at(std::size_t step) const {
    const Vector numbers = shown_numbers(array_at(step));
    std::vector<double> values;
    values.reserve(corners_.size());
    for (std::size_t corner = 0; corner < corners_.size(); ++corner) {
        const std::size_t t = corner / static_cast<std::size_t>(corners_of_cell_);
        const Index i = place_ == "vertex" ? corners_[corner]
                        : place_ == "cell" ? owners_[t]
                        : place_ == "face" ? faces_[t]
                                           : edges_[corner];
        values.push_back(i < 0 ? std::numeric_limits<double>::quiet_NaN() : numbers[i]);
    }
    return values;
}

/// Arrows stand at points, or on the visible triangles of their cells.
void StillScenes::add_arrows(StillScene& scene, std::size_t step) const {
    const Points vectors = vectors_at(step);
    if (vectors.rows() == 0 || is_curve() || (place_ != "vertex" && place_ != "cell"))
        return;
    if (place_ == "vertex") {
        scene.sites = points_;
        scene.vectors = vectors;
        return;
    }
    scene.sites.resize(std::ssize(owners_), 3);
    scene.vectors.resize(std::ssize(owners_), 3);
    for (Index i = 0; i < std::ssize(owners_); ++i) {
        scene.vectors.row(i) = vectors.row(owners_[i]);
        scene.sites.row(i) = (points_.row(corners_[3 * i]) + points_.row(corners_[3 * i + 1]) +
                              points_.row(corners_[3 * i + 2])) /
                             3;
    }
}

/// The middle if values differ by rounding alone.
double StillScenes::part(double value) const {
    return range_->is_constant ? 0.5 : (value - range_->low) / (range_->high - range_->low);
}

StillScene StillScenes::at(std::size_t step) const {
    StillScene scene;
    if (!page_.steps.empty())
        scene.time = page_.steps[step].time;
    if (first_ == nullptr)
        return scene;
    (place_ == "edge" && !is_curve() ? scene.side_values : scene.values) = values_at(step);
    add_arrows(scene, step);
    return scene;
}

} // namespace polydec
