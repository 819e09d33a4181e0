// SPDX-License-Identifier: MIT
#include "dec/fields/cell_centers.h"

#include "dec/forms/cochain.h"
#include "dec/metric/cell_volumes.h"
#include "dec/surfaces/places.h"

#include <utility>
#include <vector>

namespace polydec {

namespace {

/// Rows of the simplices averaged over each merged cell, by volume.
Points mean_over_cells(const Merging& merging, const Points& rows, const CellVolumes& volumes,
                       int k) {
    check_fit(merging.pieces(), volumes);
    Points result = Points::Zero(merging.diamond(k).rows(), rows.cols());
    for (Index cell = 0; cell < result.rows(); ++cell) {
        double volume = 0;
        for (IncidenceMatrix::InnerIterator piece(merging.diamond(k), cell); piece; ++piece) {
            result.row(cell) += volumes.primal(k)[piece.col()] * rows.row(piece.col());
            volume += volumes.primal(k)[piece.col()];
        }
        result.row(cell) *= 1 / volume;
    }
    return result;
}

/// The same of a place in each k-piece.
Points mean_over_cells(const Discretization& mesh, int k, const Points& coordinates) {
    const Points places = Places(mesh.passage(), mesh.points()).at(k, coordinates, mesh.points());
    return mean_over_cells(mesh.merging(), places, mesh.piece_volumes(), k);
}

/// The coordinates of the centroids of k-simplices.
Points middles(const Pieces& complex, int k) {
    cell_degree(complex, Side::primal, k);
    return Points::Constant(complex.size(k), k + 1, 1.0 / (k + 1));
}

/// Marks the k-cells that have a Galerkin star's n-cell beside them, or are one.
std::vector<bool> beside_galerkin(const Discretization& mesh, int k) {
    std::vector<bool> marks = mesh.chosen_stars().galerkin;
    for (int j = mesh.dimension() - 1; j >= k; --j) {
        std::vector<bool> of_faces(static_cast<std::size_t>(mesh.complex().size(j)), false);
        for (Index cell = 0; cell < mesh.complex().size(j + 1); ++cell)
            for (IncidenceMatrix::InnerIterator f(mesh.complex().coboundary(j), cell); f; ++f)
                if (marks[cell])
                    of_faces[f.col()] = true;
        marks = std::move(of_faces);
    }
    return marks;
}

} // namespace

Points site_coordinates(const Discretization& mesh, int k) {
    Points result = center_coordinates(mesh.pieces(), mesh.metric(), mesh.options().centers, k);
    const auto marks = beside_galerkin(mesh, k);
    for (Index cell = 0; cell < mesh.complex().size(k); ++cell)
        for (IncidenceMatrix::InnerIterator piece(mesh.merging().diamond(k), cell); piece; ++piece)
            if (marks[cell])
                result.row(piece.col()).setConstant(1.0 / (k + 1));
    return result;
}

Points cell_centers(const Merging& merging, const Points& points, const CellVolumes& volumes,
                    int k) {
    require_straight(merging.pieces(), points, "a cell's center");
    const auto& K = merging.pieces();
    const Points centers = combinations(K, k, center_coordinates(K, points, {}, k), points);
    return mean_over_cells(merging, centers, volumes, k);
}

Points cell_centers(const Discretization& discretization, int k) {
    cell_degree(discretization.complex(), Side::primal, k);
    if (discretization.points().cols() == 0)
        return Points(discretization.complex().size(k), 0);
    return mean_over_cells(discretization, k, site_coordinates(discretization, k));
}

Points cell_centroids(const Merging& merging, const Points& points, const CellVolumes& volumes,
                      int k) {
    require_straight(merging.pieces(), points, "a cell's centroid");
    const Points centroids =
        combinations(merging.pieces(), k, middles(merging.pieces(), k), points);
    return mean_over_cells(merging, centroids, volumes, k);
}

Points cell_centroids(const Discretization& discretization, int k) {
    require_points(discretization.points().cols(), "a cell's centroid");
    return mean_over_cells(discretization, k, middles(discretization.pieces(), k));
}

} // namespace polydec
