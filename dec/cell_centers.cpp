// SPDX-License-Identifier: MIT
#include "dec/cell_centers.h"

#include "dec/circumsphere.h"

namespace polydec {

namespace {

/// Rows of the simplices averaged over each merged cell, by volume.
Points mean_over_cells(const Merging& merging, const Points& rows, const CellVolumes& volumes,
                       int k) {
    const SparseMatrix pieces = merging.diamond(k).cast<double>().cwiseAbs();
    const Vector volume = pieces * volumes.primal[k];
    const Points weighted = volumes.primal[k].asDiagonal() * rows;
    return volume.cwiseInverse().asDiagonal() * (pieces * weighted);
}

} // namespace

Points cell_centers(const Merging& merging, const Points& points, const CellVolumes& volumes,
                    int k) {
    const Points centers = circumcenters(points, merging.input().simplices(k));
    return mean_over_cells(merging, centers, volumes, k);
}

Points cell_centroids(const Merging& merging, const Points& points, const CellVolumes& volumes,
                      int k) {
    const auto& simplices = merging.input().simplices(k);
    Points centroids = Points::Zero(simplices.rows(), points.cols());
    for (Index s = 0; s < simplices.rows(); ++s)
        for (const Index v : simplices.row(s))
            centroids.row(s) += points.row(v) / (k + 1);
    return mean_over_cells(merging, centroids, volumes, k);
}

} // namespace polydec
