// SPDX-License-Identifier: MIT
#include "meshes/tetrahedralize.h"

#include "base/decompositions.h"
#include "base/errors.h"
#include "base/listed.h"
#include "meshes/tetgen/run_tetgen.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace polydec {

namespace {

void check_mesher_options(const MesherOptions& options) {
    const double least_quality = std::sqrt(6.0) / 4.0; // of a regular tetrahedron
    const auto positive = [](double value) { return value > 0.0 && std::isfinite(value); };
    if (options.quality != 0.0 && !(positive(options.quality) && options.quality >= least_quality))
        throw InvalidInput(
            fmt::format("mesher: quality {} is out of range: the ratio of circumradius to shortest "
                        "edge is at least 0.613; choose 1.2 or more, or 0 for no bound",
                        options.quality));
    if (options.largest_volume != 0.0 && !positive(options.largest_volume))
        throw InvalidInput(fmt::format("mesher: the largest volume {} is not positive; 0 means no "
                                       "bound",
                                       options.largest_volume));
    if (!positive(options.seconds) || options.bytes == 0)
        throw InvalidInput(
            fmt::format("mesher: the limits are {} seconds and {} bytes; expected positive numbers",
                        options.seconds, options.bytes));
}

/// Circumradius over shortest edge.
double radius_to_edge(const Mesh& mesh, Eigen::Index cell) {
    const auto corner = [&](int i) { return mesh.points.row(mesh.simplices(cell, i % 4)); };
    Eigen::Matrix3d edges;
    double shortest = (corner(1) - corner(3)).norm();
    for (int j = 0; j < 3; ++j) {
        edges.row(j) = corner(j + 1) - corner(0);
        shortest =
            std::min({shortest, edges.row(j).norm(), (corner(j + 1) - corner(j + 2)).norm()});
    }
    const Eigen::Vector3d squares = 0.5 * edges.rowwise().squaredNorm();
    return (edges.inverse() * squares).norm() / shortest;
}

/// No mesher can keep the bound where the surface itself is sharp, and none says so.
void warn_of_quality(Mesh& mesh, double bound) {
    constexpr double rounding = 1.0 + 1e-9;
    Eigen::Index missed = 0;
    double worst = 0.0;
    for (Eigen::Index cell = 0; cell < mesh.simplices.rows(); ++cell) {
        const double here = radius_to_edge(mesh, cell);
        missed += here <= bound * rounding ? 0 : 1;
        worst = std::max(worst, here);
    }
    if (missed > 0)
        mesh.warnings.push_back(
            fmt::format("{} of {} tetrahedra miss the quality {}, the worst has {:.4g}: the "
                        "surface has sharp angles, or its facets must not be split",
                        missed, mesh.simplices.rows(), bound, worst));
}

} // namespace

Mesh tetrahedralize(const Mesh& surface, const MesherOptions& options, const Points& holes) {
    if (surface.dimension() != 2 || surface.ambient_dimension() != 3 ||
        surface.simplices.rows() == 0)
        throw InvalidInput(fmt::format("expected a surface of triangles in three coordinates; this "
                                       "mesh has {} cells of dimension {} in {} coordinates",
                                       surface.simplices.rows(), surface.dimension(),
                                       surface.ambient_dimension()));
    check_mesher_options(options);
    const auto input = tetgen_input(surface, holes);
    auto output = run_tetgen(input, options);
    check_tetgen_output(input, output);

    Mesh mesh;
    mesh.points = output.points.unaryExpr([&](double x) { return std::ldexp(x, input.exponent); });
    mesh.points.topRows(input.points.rows()) = surface.points(input.vertices, Eigen::indexing::all);
    mesh.simplices = std::move(output.tetrahedra);
    if (const auto isolated = surface.points.rows() - input.points.rows(); isolated > 0)
        mesh.warnings.push_back(
            fmt::format("left out {} without a triangle", counted(isolated, "vertex", "vertices")));
    if (options.quality > 0.0)
        warn_of_quality(mesh, options.quality);
    return mesh;
}

} // namespace polydec
