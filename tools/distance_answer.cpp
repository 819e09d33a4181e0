// SPDX-License-Identifier: MIT
#include "tools/distance_answer.h"

namespace polydec::tools {

namespace {

/// The points that it passes, with those on both sides of a seam.
std::vector<std::vector<double>> points_of(const Mesh& lines) {
    std::vector<std::vector<double>> points;
    for (Eigen::Index i = 0; i < lines.points.rows(); ++i) {
        const auto row = lines.points.row(i);
        std::vector<double> point(row.begin(), row.end());
        if (points.empty() || i % 2 == 1 || (row - lines.points.row(i - 1)).norm() > 1e-12)
            points.push_back(std::move(point));
    }
    return points;
}

} // namespace

const char* accuracy(DistanceMethod method) {
    return method == DistanceMethod::exact ? "exact up to rounding" : "smoothed by the heat method";
}

void Distances::write(JsonWriter& json) const {
    json.member("from", from);
    json.member("farthest", farthest);
    json.member("max", max);
    json.member("mean", mean);
    json.member("raised", raised);
    json.member("method", name(method));
    if (paths.empty())
        return;
    json.objects("paths", paths, [&](const auto& one) {
        json.member("to", one.to);
        json.member("from", one.path.source);
        json.member("length", one.path.length);
        json.member("points", points_of(one.path.lines));
    });
}

void Distances::write(Text& text) const {
    text("distance along the surface, {} source{}\n  farthest: vertex {} at {:.10g}\n  mean "
         "over the vertices: {:.10g}\n  {}\n",
         from.size(), from.size() == 1 ? "" : "s", farthest, max, mean, accuracy(method));
    for (const auto& [to, path] : paths)
        text("  path from vertex {} to {}: {} straight piece{} of length {:.10g}\n", path.source,
             to, path.lines.simplices.rows(), path.lines.simplices.rows() == 1 ? "" : "s",
             path.length);
}

} // namespace polydec::tools
