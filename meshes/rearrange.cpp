// SPDX-License-Identifier: MIT
#include "meshes/rearrange.h"

#include "base/errors.h"
#include "meshes/random.h"

#include <fmt/format.h>

#include <cmath>

namespace polydec {

Mesh perturbed(Mesh mesh, double amplitude, std::uint64_t seed) {
    if (!(amplitude >= 0.0) || !std::isfinite(amplitude))
        throw InvalidInput(
            fmt::format("perturbed: amplitude = {} is not finite and >= 0", amplitude));
    Random random(seed);
    for (Eigen::Index v = 0; v < mesh.points.rows(); ++v)
        for (Eigen::Index k = 0; k < mesh.points.cols(); ++k)
            mesh.points(v, k) += amplitude * (2.0 * random.fraction() - 1.0);
    return mesh;
}

Shuffled shuffled(const Mesh& mesh, std::uint64_t seed) {
    const auto cells = static_cast<std::size_t>(mesh.simplices.rows());
    if (!mesh.tags.empty() && mesh.tags.size() != cells)
        throw InvalidInput(fmt::format("shuffled: {} tags for {} cells", mesh.tags.size(), cells));
    Random random(seed);
    Shuffled result{mesh, random.order(mesh.points.rows()), random.order(mesh.simplices.rows())};
    std::vector<Index> new_number(result.vertices.size());
    for (std::size_t i = 0; i < new_number.size(); ++i) {
        new_number[result.vertices[i]] = static_cast<Index>(i);
        result.mesh.points.row(static_cast<Eigen::Index>(i)) = mesh.points.row(result.vertices[i]);
    }

    for (std::size_t i = 0; i < result.cells.size(); ++i)
        for (Eigen::Index c = 0; c < mesh.simplices.cols(); ++c) {
            const Index vertex = mesh.simplices(result.cells[i], c);
            if (vertex < 0 || vertex >= mesh.points.rows())
                throw InvalidInput(fmt::format("shuffled: cell {} names vertex {}, but there are "
                                               "{} vertices, numbered from 0",
                                               result.cells[i], vertex, mesh.points.rows()));
            result.mesh.simplices(static_cast<Eigen::Index>(i), c) = new_number[vertex];
        }
    for (std::size_t i = 0; i < mesh.tags.size(); ++i)
        result.mesh.tags[i] = mesh.tags[result.cells[i]];
    return result;
}

} // namespace polydec
