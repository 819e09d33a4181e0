// SPDX-License-Identifier: MIT
//
// Fig. 8: a spherical harmonic on spheres of quads and of hexagons, compared with four polygon
// Laplacians on the same meshes in the same norm.
#include "examples/paper/problems.h"
#include "examples/paper/reproductions.h"
#include "examples/paper/rivals/alexa_wardetzky.h"
#include "examples/paper/rivals/bunge_diamond.h"
#include "examples/paper/rivals/bunge_virtual_vertex.h"
#include "examples/paper/rivals/de_goes.h"

#include <fmt/format.h>

#include <filesystem>

namespace polydec::paper {

namespace {

/// Errors of a polygon Laplacian in solving S u = 20 M Y, with its own mass.
SphereError rival_error(const PolygonLaplacian& laplacian, const Points& points) {
    const Vector Y = values(harmonic, points);
    ConstrainedSolver solver({.A = laplacian.stiffness,
                              .fixed = std::vector<bool>(Y.size(), false),
                              .tied = std::vector<bool>(Y.size(), false),
                              .weights = laplacian.mass * Vector::Ones(Y.size()),
                              .definiteness = Definiteness::semidefinite,
                              .domain_dimension = 2},
                             "auto");
    const Vector u = solver.solve(20 * (laplacian.mass * Y), Vector::Zero(Y.size())).values;
    return sphere_error(laplacian.mass, u, Y);
}

struct Method {
    std::string name;
    std::function<SphereError(const Discretization&, const PolygonMesh&)> error;
};

std::vector<Method> methods() {
    const auto rival = [](PolygonLaplacian (*make)(const PolygonMesh&)) {
        return [make](const Discretization&, const PolygonMesh& polygons) {
            return rival_error(make(polygons), polygons.points);
        };
    };
    return {{"ours, primal", [](const Discretization& mesh,
                                const PolygonMesh&) { return sphere_error(mesh, Side::primal); }},
            {"ours, dual", [](const Discretization& mesh,
                              const PolygonMesh&) { return sphere_error(mesh, Side::dual); }},
            {"Alexa, Wardetzky 2011",
             rival([](const PolygonMesh& mesh) { return alexa_wardetzky(mesh); })},
            {"de Goes et al. 2020", rival([](const PolygonMesh& mesh) { return de_goes(mesh); })},
            {"Bunge et al. 2020", rival(bunge_virtual_vertex)},
            {"Bunge et al. 2021", rival(bunge_diamond)}};
}

double resolution(const Discretization& mesh) {
    return 1 / mesh.volumes().primal(1).mean();
}

/// One row per method and level, and a plot.
void add_family(Report& report, const Request& request, const Family& family, int levels) {
    Table table{family.name + "_errors",
                fmt::format("relative error of the spherical harmonic, {}", family.name),
                {"method", "faces", "1 / mean edge", "error", "order", "both normalized"},
                {}};
    SvgPlot plot{.title = fmt::format("Spherical harmonic on {}", family.name),
                 .x = {"1 / mean edge length"},
                 .y = {"relative L2 error"},
                 .slopes = {{-2}}};
    const auto all = methods();
    for (const auto& method : all)
        plot.series.push_back({method.name, {}, {}});
    std::vector<long> faces;
    std::vector<std::vector<double>> normalized(all.size());
    for (int level = 0; level < levels; ++level) {
        const auto mesh = discretized(family.make(level));
        const auto polygons = polygon_mesh(mesh.merging(), mesh.points());
        faces.push_back(mesh.complex().size(2));
        for (std::size_t i = 0; i < all.size(); ++i) {
            if (request.progress)
                request.progress(fmt::format("{}, level {}, {}", family.name, level, all[i].name));
            plot.series[i].x.push_back(resolution(mesh));
            const auto error = all[i].error(mesh, polygons);
            plot.series[i].y.push_back(error.relative);
            normalized[i].push_back(error.normalized);
        }
    }
    for (std::size_t i = 0; i < all.size(); ++i)
        for (int level = 0; level < levels; ++level) {
            const auto &x = plot.series[i].x, &y = plot.series[i].y;
            table.rows.push_back({all[i].name, faces[level], x[level], y[level],
                                  level == 0 ? none : -order_between(x, y, level),
                                  normalized[i][level]});
        }
    report.tables.push_back(std::move(table));
    report.plots.push_back({family.name + "_errors", std::move(plot)});
}

/// The same on sphere files in the given folder, if there are any.
void add_files(Report& report, const Request& request) {
    Table table{"files",
                "relative error on sphere files",
                {"file", "method", "faces", "1 / mean edge", "error", "both normalized"},
                {}};
    for (const char* file : {"quad-sphere.off", "hexaSphere.off"}) {
        const auto path = request.meshes / file;
        if (request.meshes.empty() || !std::filesystem::exists(path))
            continue;
        const auto mesh = discretized(read_mesh(path));
        const auto polygons = polygon_mesh(mesh.merging(), mesh.points());
        for (const auto& method : methods()) {
            const auto error = method.error(mesh, polygons);
            table.rows.push_back({std::string(file), method.name, long{mesh.complex().size(2)},
                                  resolution(mesh), error.relative, error.normalized});
        }
    }
    if (!table.rows.empty())
        report.tables.push_back(std::move(table));
}

} // namespace

Report fig8(const Request& request) {
    const int levels = request.levels > 0 ? request.levels : 4;
    Report report{.name = "fig8", .title = "Spherical harmonic of degree 4 (Fig. 8)"};
    for (const auto& family : sphere_families())
        add_family(report, request, family, levels);
    add_files(report, request);
    report.remarks = {
        "Error: the exact function is divided by its norm, then the problem is solved for it (Eq. "
        "12). Both normalized: the solution is divided by its norm too, which hides the part of "
        "the error that is a mere factor.",
        "The printed Y has 7 y^2 for 7 z^2 and is no eigenfunction.",
        "Alexa and Wardetzky with lambda = 2, de Goes et al. with lambda = 1; the masses of both "
        "are diagonal, those of Bunge et al. are not. All are written from their definitions.",
        "All methods are measured at one resolution, that of the polygons; the paper measures "
        "its own by the triangulated mesh."};
    return report;
}

} // namespace polydec::paper
