// SPDX-License-Identifier: MIT
#include "tests/meshes/propositions.h"

namespace polydec {

namespace {

DenseMatrix edge_vectors(const Mesh& mesh, Index cell) {
    DenseMatrix edges(mesh.ambient_dimension(), mesh.dimension());
    for (Index i = 0; i < mesh.dimension(); ++i)
        edges.col(i) =
            mesh.points.row(mesh.simplices(cell, i + 1)) - mesh.points.row(mesh.simplices(cell, 0));
    return edges;
}

/// Sorts; whether the permutation was odd.
bool sort_is_odd(std::vector<Index>& list) {
    bool odd = false;
    for (std::size_t i = 0; i < list.size(); ++i)
        for (std::size_t j = i + 1; j < list.size(); ++j)
            if (list[j] < list[i]) {
                std::swap(list[i], list[j]);
                odd = !odd;
            }
    return odd;
}

} // namespace

std::vector<Index> face_counts(const Mesh& mesh) {
    std::vector<Index> counts;
    for (int k = 0; k <= mesh.dimension(); ++k)
        counts.push_back(static_cast<Index>(test::faces(mesh, k).size()));
    return counts;
}

Index euler_characteristic(const Mesh& mesh) {
    Index result = 0, sign = 1;
    for (const Index count : face_counts(mesh)) {
        result += sign * count;
        sign = -sign;
    }
    return result;
}

double least_determinant(const Mesh& mesh) {
    double least = std::numeric_limits<double>::infinity();
    for (Index cell = 0; cell < mesh.simplices.rows(); ++cell)
        least = std::min(least, edge_vectors(mesh, cell).determinant());
    return least;
}

double enclosed_volume(const Mesh& mesh) {
    double sum = 0.0;
    for (Index cell = 0; cell < mesh.simplices.rows(); ++cell) {
        Eigen::Matrix3d corners;
        for (Index i = 0; i < 3; ++i)
            corners.row(i) = mesh.points.row(mesh.simplices(cell, i));
        sum += corners.determinant() / 6.0;
    }
    return sum;
}

FacetTally tally_facets(const Mesh& mesh) {
    std::map<std::vector<Index>, std::array<Index, 2>> facets;
    for (Index cell = 0; cell < mesh.simplices.rows(); ++cell)
        for (Index omitted = 0; omitted < mesh.simplices.cols(); ++omitted) {
            std::vector<Index> facet;
            for (Index i = 0; i < mesh.simplices.cols(); ++i)
                if (i != omitted)
                    facet.push_back(mesh.simplices(cell, i));
            const bool odd = sort_is_odd(facet) != (omitted % 2 == 1);
            ++facets[facet][odd];
        }

    FacetTally tally;
    for (const auto& [facet, ways] : facets) {
        const Index around = ways[0] + ways[1];
        ++(around > 2     ? tally.branching
           : around == 1  ? tally.boundary
           : ways[0] == 1 ? tally.coherent
                          : tally.clashing);
    }
    return tally;
}

std::vector<Index> matching_vertices(const Mesh& a, const Mesh& b, double distance) {
    std::vector<Index> result;
    for (Index v = 0; v < a.points.rows(); ++v) {
        Eigen::Index nearest = 0;
        const double least =
            (b.points.rowwise() - a.points.row(v)).rowwise().norm().minCoeff(&nearest);
        result.push_back(least <= distance ? static_cast<Index>(nearest) : -1);
    }
    return result;
}

Vector cell_volumes(const Mesh& mesh) {
    Vector result(mesh.simplices.rows());
    for (Index cell = 0; cell < result.size(); ++cell)
        result[cell] = test::total_volume({mesh.points, mesh.simplices.row(cell), {}});
    return result;
}

std::vector<std::vector<Index>> sorted_rows(const Simplices& cells) {
    std::vector<std::vector<Index>> rows;
    for (Index cell = 0; cell < cells.rows(); ++cell) {
        rows.emplace_back(cells.row(cell).begin(), cells.row(cell).end());
        std::sort(rows.back().begin(), rows.back().end());
    }
    std::sort(rows.begin(), rows.end());
    return rows;
}

bool same_geometry(const Mesh& a, const Mesh& b) {
    if (a.points.rows() != b.points.rows() || a.points.cols() != b.points.cols())
        return false;
    const auto in_b = matching_vertices(a, b, 1e-12);
    const Simplices cells = a.simplices.unaryExpr([&](Index v) { return in_b[v]; });
    return sorted_rows(cells) == sorted_rows(b.simplices);
}

PolygonMesh mesh_of(const Points& points, const std::vector<std::vector<Index>>& cells) {
    PolygonMesh mesh;
    mesh.points = points;
    for (const auto& cell : cells)
        mesh.add(cell);
    return mesh;
}

} // namespace polydec
