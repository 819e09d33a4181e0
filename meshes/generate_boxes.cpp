// SPDX-License-Identifier: MIT
#include "base/decompositions.h"
#include "base/errors.h"
#include "base/lists.h"
#include "base/permutation_sign.h"
#include "base/random.h"
#include "meshes/edges.h"
#include "meshes/generate.h"
#include "meshes/generate_parts.h"
#include "meshes/split_cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace polydec {

namespace {

/// Vertex number steps along the axes of a box of vertices numbered lexicographically.
std::vector<Index> strides(const std::vector<int>& cells) {
    std::vector<Index> result(cells.size(), 1);
    for (std::size_t k = cells.size(); k-- > 1;)
        result[k - 1] = result[k] * (cells[k] + 1);
    return result;
}

void check_box(std::string_view generator, const std::vector<int>& cells,
               const std::vector<double>& lengths) {
    check_count(generator, "n", static_cast<std::int64_t>(cells.size()), 1, 12);
    double vertices = 1.0, simplices = 1.0;
    for (std::size_t k = 0; k < cells.size(); ++k) {
        check_count(generator, fmt::format("cells[{}]", k), cells[k], 1);
        vertices *= cells[k] + 1.0;
        simplices *= (k + 1.0) * cells[k];
    }
    if (!lengths.empty() && lengths.size() != cells.size())
        throw InvalidInput(
            fmt::format("{}: {} lengths for {} axes; give one for each axis, or none", generator,
                        lengths.size(), cells.size()));
    for (std::size_t k = 0; k < lengths.size(); ++k)
        check_length(generator, fmt::format("lengths[{}]", k), lengths[k]);
    check_sizes(generator, vertices, simplices, static_cast<int>(cells.size()));
}

/// A grid of boxes: points in lexicographic order, still without simplices.
struct Boxes {
    std::vector<Index> stride;
    std::vector<Index> origins; ///< lowest vertices of the boxes
    Mesh mesh;
};

Boxes boxes(const std::vector<int>& cells, const std::vector<double>& lengths) {
    const auto n = static_cast<Index>(cells.size());
    Boxes result{strides(cells), {}, {}};
    Points& points = result.mesh.points;
    points.resize(result.stride[0] * (static_cast<Eigen::Index>(cells[0]) + 1), n);
    for (Index v = 0; v < points.rows(); ++v) {
        bool is_origin = true;
        for (Index k = 0, rest = v; k < n; rest %= result.stride[k++]) {
            const Index i = rest / result.stride[k];
            const double length = lengths.empty() ? 1.0 : lengths[k];
            points(v, k) = static_cast<double>(i) / cells[k] * length;
            is_origin = is_origin && i < cells[k];
        }
        if (is_origin)
            result.origins.push_back(v);
    }
    Eigen::Index in_a_box = 1;
    for (Index k = 2; k <= n; ++k)
        in_a_box *= k;
    result.mesh.simplices.resize(in_a_box * static_cast<Eigen::Index>(result.origins.size()),
                                 n + 1);
    return result;
}

/// Turns simplices around whose determinant is negative.
void orient(Mesh& mesh) {
    for (auto simplex : mesh.simplices.rowwise())
        if (edges_at_first(mesh.points, simplex).determinant() < 0.0)
            std::swap(simplex[0], simplex[1]);
}

} // namespace

Mesh kuhn(const std::vector<int>& cells, const std::vector<double>& lengths) {
    check_box("kuhn", cells, lengths);
    Boxes grid = boxes(cells, lengths);
    const auto n = static_cast<Index>(cells.size());

    // Every order of the axes is a path along the edges of a cube from its origin to the opposite
    // corner; the vertices of the path span a simplex.
    std::vector<Index> axes = numbers_below(n);
    Eigen::Index simplex = 0;
    do {
        Eigen::Matrix<Index, 1, Eigen::Dynamic> path(n + 1);
        path[0] = 0;
        for (Index k = 0; k < n; ++k)
            path[k + 1] = path[k] + grid.stride[axes[k]];
        if (permutation_sign(axes) < 0)
            std::swap(path[0], path[1]);
        for (const Index origin : grid.origins)
            grid.mesh.simplices.row(simplex++) = path.array() + origin;
    } while (std::next_permutation(axes.begin(), axes.end()));
    return std::move(grid.mesh);
}

Mesh kuhn(int n, int cells_per_side) {
    check_count("kuhn", "n", n, 1, 12);
    check_count("kuhn", "cells_per_side", cells_per_side, 1);
    return kuhn(std::vector<int>(n, cells_per_side));
}

Mesh split_boxes(const std::vector<int>& cells, const std::vector<double>& lengths,
                 std::uint64_t seed) {
    check_box("split_boxes", cells, lengths);
    Boxes grid = boxes(cells, lengths);
    const auto n = static_cast<Index>(cells.size());
    const std::vector<Index> rank = Random(seed).order(grid.mesh.points.rows());
    std::vector<Index> vertex(rank.size());
    for (std::size_t v = 0; v < rank.size(); ++v)
        vertex[rank[v]] = static_cast<Index>(v);

    const CellShape cube = cube_shape(n);
    std::vector<Index> corners(std::size_t{1} << static_cast<unsigned>(n)), simplices;
    for (const Index origin : grid.origins) {
        for (std::size_t c = 0; c < corners.size(); ++c) {
            Index corner = origin;
            for (Index k = 0; k < n; ++k)
                corner += static_cast<Index>(c >> static_cast<unsigned>(k) & 1U) * grid.stride[k];
            corners[c] = rank[corner];
        }
        pull_cell(cube, corners, simplices);
    }
    for (Index& corner : simplices)
        corner = vertex[corner];
    grid.mesh.simplices = simplices_of(simplices, n + 1);
    orient(grid.mesh);
    return std::move(grid.mesh);
}

} // namespace polydec
