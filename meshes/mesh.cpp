// SPDX-License-Identifier: MIT
#include "meshes/mesh.h"

#include "base/errors.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace polydec {

void check_facet_tags(const Mesh& mesh) {
    const auto& [facets, tags] = mesh.facet_tags;
    if (static_cast<Eigen::Index>(tags.size()) != facets.rows())
        throw InvalidInput(fmt::format("there are {} tags for {} facets; give every facet one",
                                       tags.size(), facets.rows()));
    if (facets.rows() > 0 && facets.cols() != mesh.dimension())
        throw InvalidInput(fmt::format("facets with tags have {} vertices; expected {}, as those "
                                       "of cells of dimension {} have",
                                       facets.cols(), mesh.dimension(), mesh.dimension()));
    for (Eigen::Index facet = 0; facet < facets.rows(); ++facet) {
        const auto vertices = facets.row(facet);
        if (vertices.minCoeff() < 0 || vertices.maxCoeff() >= mesh.points.rows())
            throw InvalidInput(fmt::format("facet {} of those with tags (vertices {}) names a "
                                           "vertex that is not among the {} given\n"
                                           "Vertices are numbered from 0.",
                                           facet, fmt::join(vertices.begin(), vertices.end(), " "),
                                           mesh.points.rows()),
                               {.degree = mesh.dimension() - 1,
                                .cells = {static_cast<Index>(facet)},
                                .vertices = {vertices.begin(), vertices.end()}});
    }
}

} // namespace polydec
