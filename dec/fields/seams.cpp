// SPDX-License-Identifier: MIT
#include "dec/fields/seams.h"

#include "base/errors.h"
#include "dec/discretization/glued_box.h"
#include "dec/fields/developed_cells.h"
#include "dec/metric/simplex_geometry.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace polydec {

namespace {

/// The basis_at each place of a facet, with its corners ordered as in the glued mesh.
DenseMatrix basis_in_box(const GluedBox& box, const Coface& inside, Index facet) {
    const Discretization& mesh = box.mesh();
    const int n = mesh.dimension();
    const auto corners = vertices(mesh.input().simplices(n - 1), facet);
    std::vector<Index> ordered(corners.begin(), corners.end());
    const auto& onto = box.map(0).onto;
    std::sort(ordered.begin(), ordered.end(), [&](Index v, Index w) { return onto[v] < onto[w]; });
    const Points& points = mesh.measured_input_points();
    const Index apex = mesh.input().simplices(n)(inside.cell, inside.omitted);
    return basis_at(points(ordered, Eigen::indexing::all), points.row(apex));
}

/// Whether a translation does not take one basis to the other, on the other side of the facet.
bool turns(const DenseMatrix& basis, const DenseMatrix& other) {
    constexpr double tolerance = 1e-6;
    const auto edges = basis.rows() - 1;
    return (basis - other).topRows(edges).norm() > tolerance * basis.topRows(edges).norm() ||
           basis.row(edges).dot(other.row(edges)) > 0;
}

/// The facets of the mesh whose places differ by a turn or a reflection.
std::vector<Index> turned_facets(const Discretization& mesh) {
    std::vector<Index> turned;
    if (!mesh.box())
        return turned;
    const int n = mesh.dimension();
    const Cofaces cofaces(mesh.box()->mesh().input(), n);
    const auto& onto = mesh.box()->map(n - 1).onto;
    std::vector<Index> first(static_cast<std::size_t>(mesh.input().size(n - 1)), -1);
    for (Index s = 0; s < std::ssize(onto); ++s) {
        const Index place = std::exchange(first[onto[s]], s);
        if (place >= 0 && turns(basis_in_box(*mesh.box(), cofaces.of(place)[0], place),
                                basis_in_box(*mesh.box(), cofaces.of(s)[0], s)))
            turned.push_back(onto[s]);
    }
    return turned;
}

} // namespace

DenseMatrix edges_beside(const Discretization& mesh, SimplexFaces& edges, Index piece) {
    const auto [points, corners] = mesh.places_of_pieces();
    const auto& list = edges.of(piece);
    DenseMatrix result(std::ssize(list), points.cols());
    for (Index i = 0; i < result.rows(); ++i) {
        const auto& ends = edges.positions()[i];
        result.row(i) = orientation(mesh.pieces(), 1, list[i]) *
                        (points.row(corners(piece, ends[1])) - points.row(corners(piece, ends[0])));
    }
    return result;
}

void refuse_turned_vertices(const Discretization& mesh, std::string_view what) {
    const auto facets = turned_facets(mesh);
    if (facets.empty())
        return;
    const auto corners = mesh.input().vertex_numbers(mesh.dimension() - 1, facets.front());
    throw InvalidInput(
        fmt::format("{} is not defined on this glued mesh: its seams turn, so a vector at vertex "
                    "{} has another direction on each side; use vectors at the cells",
                    what, corners.front()),
        {.vertices = corners});
}

void refuse_turned_cells(const Discretization& mesh, std::string_view what) {
    const int n = mesh.dimension();
    for (const Index facet : turned_facets(mesh)) {
        const auto& carrier = mesh.merging().carriers(n - 1)[facet];
        if (carrier.dimension < n)
            continue;
        const auto corners = cell_vertices(mesh, n, carrier.cell);
        throw InvalidInput(
            fmt::format("{} is not defined at merged cell {} (vertices {}): a seam that turns cuts "
                        "it, so its vector has another direction in each part; do not merge",
                        what, carrier.cell, fmt::join(corners, ", ")),
            {.degree = n, .cells = {carrier.cell}, .vertices = corners});
    }
}

} // namespace polydec
