// SPDX-License-Identifier: MIT
#include "io/pages/still_scene.h"

#include "base/errors.h"

#include <limits>

namespace polydec {

StillScenes::StillScenes(const PageContent& content)
    : content_(content),
      shown_(content.shown),
      visible_(content.visible()),
      cells_(content.faces.count_cells()) {
    if (content.faces.size() == 0)
        throw InvalidInput("a picture needs lines or faces, and this page has only points: write a "
                           ".vtu file");
    if (shown_.field == nullptr)
        return;
    const auto [low, high] =
        shown_.strengths.empty() ? range_of(page(), *shown_.field) : range_of(shown_.strengths);
    range_ = color_range(low, high);
}

std::string StillScenes::name() const {
    return shown_.at(page(), 0).name;
}

/// The vectors whose lengths are shown, one for each value; or none.
Points StillScenes::vectors_at(std::size_t step) const {
    if (!shown_.vectors.empty())
        return in_space(shown_.vectors[step]);
    const VtuArray& array = shown_.at(page(), step);
    return array.components == 3 ? Points(rows_of(array)) : Points(0, 3);
}

/// At the corners; of fields on edges, on the sides from the corners to the next.
std::vector<double> StillScenes::values_at(std::size_t step) const {
    const Vector numbers = shown_numbers(shown_.at(page(), step));
    std::vector<double> values;
    values.reserve(corners().size());
    for (Index corner = 0; corner < std::ssize(corners()); ++corner) {
        const Index i = visible_.entry(shown_.place, corner);
        values.push_back(i < 0 ? std::numeric_limits<double>::quiet_NaN() : numbers[i]);
    }
    return values;
}

/// Arrows stand at points, or on the visible triangles of their cells.
void StillScenes::add_arrows(StillScene& scene, std::size_t step) const {
    const Points vectors = vectors_at(step);
    if (vectors.rows() == 0 || is_curve() || (shown_.place != "vertex" && shown_.place != "cell"))
        return;
    if (shown_.place == "vertex") {
        scene.sites = points();
        scene.vectors = vectors;
        return;
    }
    scene.sites.resize(visible_.size(), 3);
    scene.vectors.resize(visible_.size(), 3);
    for (Index i = 0; i < visible_.size(); ++i) {
        scene.vectors.row(i) = vectors.row(visible_.owners[i][0]);
        scene.sites.row(i) = (points().row(corners()[3 * i]) + points().row(corners()[3 * i + 1]) +
                              points().row(corners()[3 * i + 2])) /
                             3;
    }
}

StillScene StillScenes::at(std::size_t step) const {
    StillScene scene;
    if (!page().steps.empty())
        scene.time = page().steps[step].time;
    if (shown_.field == nullptr)
        return scene;
    (shown_.place == "edge" && !is_curve() ? scene.side_values : scene.values) = values_at(step);
    add_arrows(scene, step);
    return scene;
}

} // namespace polydec
