// SPDX-License-Identifier: MIT
//
// Fig. 10: mean curvature H = |Delta (x, y, z)| / 2 of UV spheres, exactly 1, in three norms.
#include "examples/paper/problems.h"
#include "examples/paper/reproductions.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace polydec::paper {

namespace {

struct Norm {
    std::string name;
    double (*of)(const Vector& areas, const Vector& errors);
};

const std::array<Norm, 3> norms{
    {{"maximum", [](const Vector&, const Vector& errors) { return errors.cwiseAbs().maxCoeff(); }},
     {"L2 by area",
      [](const Vector& areas, const Vector& errors) { return weighted_norm(areas, errors); }},
     {"the paper's RMSE", [](const Vector& areas, const Vector& errors) {
          return areas.cwiseProduct(errors).norm() / std::sqrt(double(errors.size()));
      }}}};

} // namespace

Report fig10(const Request& request) {
    const int levels = request.levels > 0 ? request.levels : 5;
    Table table{
        "curvature",
        "error of the mean curvature of a UV sphere",
        {"subdivisions", "maximum", "order", "L2 by area", "order", "the paper's RMSE", "order"},
        {}};
    SvgPlot plot{.title = "Mean curvature on UV spheres",
                 .x = {"1 / subdivisions"},
                 .y = {"error, in the norm named"},
                 .slopes = {{2, 0}}};
    for (const auto& norm : norms)
        plot.series.push_back({norm.name, {}, {}});
    for (int level = 0; level < levels; ++level) {
        const int subdivisions = 10 << level;
        if (request.progress)
            request.progress(fmt::format("{} x {} subdivisions", subdivisions, subdivisions));
        const auto sphere = discretized(uv_sphere(subdivisions, subdivisions));
        const Vector areas = star(sphere.volumes(), 0).diagonal();
        const DenseMatrix normal = laplacian(sphere, 0).matrix() * DenseMatrix(sphere.points());
        const Vector errors = 1 - normal.rowwise().norm().array() / 2;
        std::vector<Entry> row{long{subdivisions}};
        for (std::size_t i = 0; i < norms.size(); ++i) {
            auto& [name, x, y, trace] = plot.series[i];
            x.push_back(1.0 / subdivisions);
            y.push_back(norms[i].of(areas, errors));
            row.emplace_back(y.back());
            row.emplace_back(level == 0 ? none : order_between(x, y, level));
        }
        table.rows.push_back(std::move(row));
    }
    return {.name = "fig10",
            .title = "Mean curvature (Fig. 10)",
            .tables = {std::move(table)},
            .plots = {{"curvature", std::move(plot)}},
            .remarks = {"The paper reads a rate of 2 off its RMSE. The area stands inside the "
                        "square there, which multiplies the error by about h^2 and more: the "
                        "maximum error is what has order 2."}};
}

} // namespace polydec::paper
