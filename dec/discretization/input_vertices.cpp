// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "dec/discretization/cell_data.h"

#include <fmt/format.h>

#include <algorithm>

namespace polydec {

Index count_vertices(const Discretization& mesh) {
    return mesh.complex().size(0) + static_cast<Index>(mesh.isolated().rows());
}

std::vector<Index> vertices_of_cells(const Discretization& mesh) {
    const SimplicialComplex& input = mesh.input();
    const auto unused = static_cast<Index>(mesh.isolated().rows());
    std::vector<Index> result(static_cast<std::size_t>(mesh.complex().size(0)));
    for (Index v = 0; v < std::ssize(result); ++v)
        result[v] = v < input.size(0) ? input.vertex_number(v) : v + unused;
    return result;
}

std::vector<Index> cells_of_vertices(const Discretization& mesh, std::string_view what,
                                     const std::vector<Index>& vertices) {
    const std::vector<Index> known = vertices_of_cells(mesh);
    std::vector<Index> cells;
    for (const Index vertex : vertices) {
        const auto found = std::lower_bound(known.begin(), known.end(), vertex);
        if (found != known.end() && *found == vertex) {
            cells.push_back(static_cast<Index>(found - known.begin()));
            continue;
        }
        const Index count = count_vertices(mesh);
        const auto flaw =
            vertex < 0 || vertex >= count
                ? fmt::format("there is no such vertex; vertices are numbered from 0 to {}",
                              count - 1)
                : "no cell uses this vertex; choose a vertex of a cell";
        throw InvalidInput(fmt::format("{} {}: {}", what, vertex, flaw), {.vertices = {vertex}});
    }
    return cells;
}

} // namespace polydec
