// SPDX-License-Identifier: MIT
#include "meshes/tetrahedralize.h"

#include "base/decompositions.h"
#include "base/errors.h"

#include <fmt/format.h>

#include <algorithm>

namespace polydec {

namespace {

MesherInput facets_of(const Mesh& surface) {
    MesherInput input;
    input.points = surface.points;
    const auto& triangles = surface.simplices;
    input.corners.assign(triangles.data(), triangles.data() + triangles.size());
    for (Eigen::Index f = 0; f <= triangles.rows(); ++f)
        input.offsets.push_back(static_cast<Index>(f * triangles.cols()));
    return input;
}

Eigen::Index count_isolated(const MesherInput& input) {
    std::vector<bool> used(static_cast<std::size_t>(input.points.rows()), false);
    for (const Index corner : input.corners)
        used[static_cast<std::size_t>(corner)] = true;
    return std::count(used.begin(), used.end(), false);
}

/// Circumradius over shortest edge.
double quality(const Mesh& mesh, Eigen::Index cell) {
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
        const double here = quality(mesh, cell);
        missed += here <= bound * rounding ? 0 : 1;
        worst = std::max(worst, here);
    }
    if (missed > 0) {
        mesh.warnings.push_back(
            fmt::format("{} of {} tetrahedra miss the quality {}, the worst has {:.4g}: the "
                        "surface is sharp or its boundary may not be split",
                        missed, mesh.simplices.rows(), bound, worst));
    }
}

} // namespace

Mesh tetrahedralize(const Mesh& surface, const MesherOptions& options, const Points& holes,
                    const std::string& engine) {
    if (surface.dimension() != 2 || surface.ambient_dimension() != 3 ||
        surface.simplices.rows() == 0) {
        throw InvalidInput(fmt::format("tetrahedra are made within surfaces of triangles in three "
                                       "coordinates; this mesh has {} cells of dimension {} in {}",
                                       surface.simplices.rows(), surface.dimension(),
                                       surface.ambient_dimension()));
    }
    auto input = facets_of(surface);
    input.holes = holes;
    auto output = tetrahedralize(input, options, engine);

    Mesh mesh;
    mesh.points = std::move(output.points);
    mesh.simplices = std::move(output.tetrahedra);
    if (const auto isolated = count_isolated(input); isolated > 0) {
        mesh.warnings.push_back(fmt::format("left out {} {} of no triangle", isolated,
                                            isolated == 1 ? "vertex" : "vertices"));
    }
    if (options.quality > 0.0)
        warn_of_quality(mesh, options.quality);
    return mesh;
}

} // namespace polydec
