// SPDX-License-Identifier: MIT
#include "dec/fields/cell_centers.h"

#include "dec/forms/cochain.h"
#include "dec/metric/cell_volumes.h"
#include "dec/metric/circumsphere.h"

namespace polydec {

namespace {

/// Rows of the simplices averaged over each merged cell, by volume.
Points mean_over_cells(const Merging& merging, const Points& rows, const CellVolumes& volumes,
                       int k) {
    check_fit(merging.pieces(), volumes);
    const SparseMatrix pieces = merging.diamond(k).cast<double>().cwiseAbs();
    const Vector volume = pieces * volumes.primal(k);
    const Points weighted = volumes.primal(k).asDiagonal() * rows;
    return volume.cwiseInverse().asDiagonal() * (pieces * weighted);
}

} // namespace

Points cell_centers(const Merging& merging, const Points& points, const CellVolumes& volumes,
                    int k) {
    require_points(merging.pieces(), points, "a cell's center");
    const Points centers = center_points(merging.pieces(), points, points, {}, k);
    return mean_over_cells(merging, centers, volumes, k);
}

Points cell_centers(const Discretization& discretization, int k) {
    cell_degree(discretization.complex(), Side::primal, k);
    if (discretization.points().cols() == 0)
        return Points(discretization.complex().size(k), 0);
    const auto& merging = discretization.merging();
    const Points centers =
        center_points(merging.pieces(), discretization.metric(), discretization.points(),
                      discretization.options().centers, k);
    return mean_over_cells(merging, centers, discretization.piece_volumes(), k);
}

Points cell_centroids(const Merging& merging, const Points& points, const CellVolumes& volumes,
                      int k) {
    require_points(merging.pieces(), points, "a cell's centroid");
    const auto& simplices = merging.pieces().simplices(k);
    Points centroids = Points::Zero(simplices.rows(), points.cols());
    for (Index s = 0; s < simplices.rows(); ++s)
        for (const Index v : simplices.row(s))
            centroids.row(s) += points.row(v) / (k + 1);
    return mean_over_cells(merging, centroids, volumes, k);
}

} // namespace polydec
