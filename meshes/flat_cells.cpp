// SPDX-License-Identifier: MIT
#include "meshes/flat_cells.h"

#include "base/lists.h"
#include "meshes/edges.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace polydec {

namespace {

constexpr double flat_tolerance = 1e-12;

/// Edges from vertex 0 of a cell, one a row, scaled to a largest coordinate of 1 (or all zero).
/// Halves keep the difference of very large numbers finite.
void scaled_edges(const Mesh& mesh, Index cell, Points& edges) {
    const auto vertices = mesh.simplices.row(cell);
    for (Index i = 0; i < edges.rows(); ++i)
        edges.row(i) = 0.5 * mesh.points.row(vertices[i + 1]) - 0.5 * mesh.points.row(vertices[0]);
    const double largest = edges.size() == 0 ? 0.0 : edges.cwiseAbs().maxCoeff();
    if (largest > 0.0)
        edges /= largest;
}

/// Whether n! times the volume, which is the product of the edges' lengths after orthogonalization,
/// is too small. The longest remainder goes first, so that no small one is blurred by a larger one.
bool is_flat(const Mesh& mesh, Index cell, Points& edges) {
    scaled_edges(mesh, cell, edges);
    const double scale = std::sqrt(squared_longest_edge(edges));
    double ratio = 1.0;
    for (Index k = 0; k < edges.rows(); ++k) {
        Eigen::Index longest = 0;
        const double square =
            edges.bottomRows(edges.rows() - k).rowwise().squaredNorm().maxCoeff(&longest);
        if (!(square > 0.0))
            return true;
        ratio *= std::sqrt(square) / scale;
        edges.row(k).swap(edges.row(k + longest));
        for (Index i = k + 1; i < edges.rows(); ++i)
            edges.row(i) -= edges.row(i).dot(edges.row(k)) / square * edges.row(k);
    }
    return ratio <= flat_tolerance;
}

/// Whether a cell is thick enough to spare it the careful test, as nearly all cells are: n! times
/// the volume, without pivots, exceeds 1e-5 times a bound on the longest edge to the n. Numbers out
/// of range fail. n_fixed and N_fixed are n and N, or -1 for any.
template <int n_fixed, int N_fixed>
bool is_clearly_thick(const Mesh& mesh, Index cell, std::vector<double>& scratch) {
    const auto n = n_fixed > 0 ? n_fixed : mesh.simplices.cols() - 1;
    const auto N = N_fixed > 0 ? N_fixed : mesh.points.cols();
    const Index* const vertices = mesh.simplices.data() + cell * (n + 1);
    const auto corner = [&](Eigen::Index i) { return mesh.points.data() + vertices[i] * N; };
    const double* const first = corner(0);
    double* const inverse = scratch.data() + n * N; // squared lengths of the orthogonal edges
    double longest = 0, volume = 1, bound = 1e-10;  // all squared
    for (Eigen::Index i = 0; i < n; ++i) {
        const double* const end = corner(i + 1);
        double* const edge = scratch.data() + i * N;
        double length = 0, height = 0;
        for (Eigen::Index c = 0; c < N; ++c) {
            edge[c] = end[c] - first[c];
            length += edge[c] * edge[c];
        }
        for (Eigen::Index j = 0; j < i; ++j) {
            const double* const other = scratch.data() + j * N;
            double share = 0;
            for (Eigen::Index c = 0; c < N; ++c)
                share += edge[c] * other[c];
            share *= inverse[j];
            for (Eigen::Index c = 0; c < N; ++c)
                edge[c] -= share * other[c];
        }
        for (Eigen::Index c = 0; c < N; ++c)
            height += edge[c] * edge[c];
        inverse[i] = 1 / height;
        volume *= height;
        longest = std::max(longest, length);
    }
    for (Eigen::Index i = 0; i < n; ++i)
        bound *= 4 * longest; // between other vertices twice as long at most
    return volume > bound && std::isfinite(volume);
}

using Facet = std::vector<Index>;

/// The vertices of a cell without the one at a place, ascending.
Facet facet(const Simplices& cells, Index cell, Index omitted) {
    Facet result;
    for (Index i = 0; i < cells.cols(); ++i)
        if (i != omitted)
            result.push_back(cells(cell, i));
    std::sort(result.begin(), result.end());
    return result;
}

/// The facets of some cells, each with all cells of the mesh around it.
std::map<Facet, std::vector<Index>> around_facets(const Mesh& mesh,
                                                  const std::vector<Index>& of_cells) {
    const Simplices& cells = mesh.simplices;
    std::map<Facet, std::vector<Index>> around;
    std::vector<bool> marked(mesh.points.rows(), false);
    for (const Index cell : of_cells)
        for (Index i = 0; i < cells.cols(); ++i) {
            around[facet(cells, cell, i)];
            marked[cells(cell, i)] = true;
        }
    // Of the other cells only those with at most one unmarked vertex can have such a facet.
    for (Index cell = 0; cell < cells.rows(); ++cell) {
        Index near = 0;
        for (Index i = 0; i < cells.cols(); ++i)
            near += marked[cells(cell, i)];
        for (Index i = 0; i < cells.cols() && near + 1 >= cells.cols(); ++i)
            if (const auto found = around.find(facet(cells, cell, i)); found != around.end())
                found->second.push_back(cell);
    }
    return around;
}

/// Takes flat cells away as long as one is bound to other cells by at most one facet. Taking one
/// away only loosens the others, so the order does not matter.
FlatCells peel(const Mesh& mesh, const std::vector<Index>& flat) {
    auto staying = around_facets(mesh, flat);
    auto is_candidate = marks_at(flat, mesh.simplices.rows());
    std::vector<Index> queue = flat;
    while (!queue.empty()) {
        const Index cell = queue.back();
        queue.pop_back();
        std::vector<std::vector<Index>*> sides;
        for (Index i = 0; i < mesh.simplices.cols(); ++i)
            sides.push_back(&staying.at(facet(mesh.simplices, cell, i)));
        const auto bonds = std::count_if(sides.begin(), sides.end(),
                                         [](const auto* side) { return side->size() > 1; });
        if (!is_candidate[cell] || bonds > 1)
            continue;
        is_candidate[cell] = false;
        // What changes for the others is that one may now be alone at a facet.
        for (auto* const side : sides) {
            std::erase(*side, cell);
            if (side->size() == 1 && is_candidate[side->front()])
                queue.push_back(side->front());
        }
    }
    FlatCells result;
    for (const Index cell : flat)
        (is_candidate[cell] ? result.stuck : result.removable).push_back(cell);
    return result;
}

} // namespace

std::vector<Index> flat_cells(const Mesh& mesh) {
    std::vector<Index> flat;
    if (mesh.simplices.size() == 0)
        return flat;
    Points edges(mesh.dimension(), mesh.ambient_dimension());
    std::vector<double> scratch(edges.size() + edges.rows());
    const auto [n, N] = std::pair(mesh.dimension(), mesh.ambient_dimension());
    const auto is_thick = N == 3 && n == 2   ? is_clearly_thick<2, 3>
                          : N == 3 && n == 3 ? is_clearly_thick<3, 3>
                                             : is_clearly_thick<-1, -1>;
    for (Index cell = 0; cell < mesh.simplices.rows(); ++cell)
        if (!is_thick(mesh, cell, scratch) && is_flat(mesh, cell, edges))
            flat.push_back(cell);
    return flat;
}

FlatCells find_flat_cells(const Mesh& mesh) {
    const std::vector<Index> flat = flat_cells(mesh);
    return flat.empty() ? FlatCells{} : peel(mesh, flat);
}

} // namespace polydec
