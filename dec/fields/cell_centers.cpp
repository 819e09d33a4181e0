// SPDX-License-Identifier: MIT
#include "dec/fields/cell_centers.h"

#include "dec/forms/cochain.h"
#include "dec/metric/cell_volumes.h"
#include "dec/surfaces/places.h"

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

/// Whether a star has an entry between two facets of a cell.
bool couples_facets_of(const SparseMatrix& M, const IncidenceRow& faces) {
    for (const SignedFace& f : faces) {
        SparseMatrix::InnerIterator entry(M, f.face); // both are in ascending order
        for (const SignedFace& g : faces) {
            while (entry && entry.col() < g.face)
                ++entry;
            if (g.face != f.face && entry && entry.col() == g.face && entry.value() != 0)
                return true;
        }
    }
    return false;
}

/// The coordinates of the centroids of k-simplices.
Points middles(const Pieces& complex, int k) {
    cell_degree(complex, Side::primal, k);
    return Points::Constant(complex.size(k), k + 1, 1.0 / (k + 1));
}

} // namespace

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
    return mean_over_cells(discretization, k,
                           center_coordinates(discretization.pieces(), discretization.metric(),
                                              discretization.centers(), k));
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

Points site_coordinates(const Discretization& discretization) {
    const int n = discretization.dimension();
    Points result = center_coordinates(discretization.pieces(), discretization.metric(),
                                       discretization.centers(), n);
    if (n == 0 || discretization.stars()[n - 1].is_diagonal())
        return result;
    const SparseMatrix M = discretization.stars()[n - 1].matrix();
    const Incidences& faces = discretization.complex().incidences(n - 1);
    const IncidenceMatrix& pieces = discretization.merging().diamond(n);
    for (Index cell = 0; cell < faces.rows(); ++cell)
        if (couples_facets_of(M, faces[cell]))
            for (IncidenceMatrix::InnerIterator piece(pieces, cell); piece; ++piece)
                result.row(piece.col()).setConstant(1.0 / (n + 1));
    return result;
}

Points dual_sites(const Discretization& discretization) {
    const int n = discretization.dimension();
    if (discretization.points().cols() == 0)
        return cell_centers(discretization, n);
    return mean_over_cells(discretization, n, site_coordinates(discretization));
}

Points facet_sites(const Discretization& discretization) {
    const int n = discretization.dimension();
    return discretization.stars()[n - 1].is_diagonal() || discretization.points().cols() == 0
               ? cell_centers(discretization, n - 1)
               : cell_centroids(discretization, n - 1);
}

} // namespace polydec
