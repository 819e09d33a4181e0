// SPDX-License-Identifier: MIT
#include "dec/fields/cell_centers.h"

#include "dec/forms/cochain.h"
#include "dec/metric/cell_volumes.h"
#include "dec/metric/circumsphere.h"
#include "dec/metric/triangle.h"
#include "dec/surfaces/glued_volumes.h"

namespace polydec {

namespace {

/// Rows of the simplices averaged over each merged cell, by volume.
Points mean_over_cells(const Merging& merging, const Points& rows, const CellVolumes& volumes,
                       int k) {
    check_fit(merging.input(), volumes);
    const SparseMatrix pieces = merging.diamond(k).cast<double>().cwiseAbs();
    const Vector volume = pieces * volumes.primal(k);
    const Points weighted = volumes.primal(k).asDiagonal() * rows;
    return volume.cwiseInverse().asDiagonal() * (pieces * weighted);
}

Points edge_centers(const GluedSurface& surface, const Points& points) {
    Points centers(surface.edges(), points.cols());
    for (Index e = 0; e < surface.edges(); ++e)
        centers.row(e) =
            (points.row(surface.first_vertex(e)) + points.row(surface.last_vertex(e))) / 2;
    return centers;
}

/// A circumcenter has the barycentric coordinate a^2 cot(alpha) / 4A at the corner opposite to a;
/// the intrinsic triangle's are applied to its corners in space.
Points triangle_centers(const IntrinsicTessellation& intrinsic, const Points& points) {
    const auto& surface = intrinsic.surface();
    Points centers = Points::Zero(surface.triangles(), points.cols());
    for (Index t = 0; t < surface.triangles(); ++t) {
        const auto side = side_lengths(surface, intrinsic.delaunay.lengths, t);
        const double area = intrinsic.triangle_volumes.primal(2)[t];
        for (Index i = 0; i < 3; ++i) {
            const double a = side[i], b = side[(i + 1) % 3], c = side[(i + 2) % 3];
            const double weight = a * a * corner_cotangent(a, b, c, area) / (4 * area);
            centers.row(t) += weight * points.row(surface.tail(3 * t + (i + 2) % 3));
        }
    }
    return centers;
}

} // namespace

Points cell_centers(const Merging& merging, const Points& points, const CellVolumes& volumes,
                    int k) {
    require_points(merging.input(), points, "a cell's center");
    const Points centers = circumcenters(points, merging.input().simplices(k));
    return mean_over_cells(merging, centers, volumes, k);
}

Points cell_centers(const Discretization& discretization, int k) {
    cell_degree(discretization.complex(), Side::primal, k);
    if (discretization.points.cols() == 0)
        return Points(discretization.complex().size(k), 0);
    if (k == 0)
        return vertex_points(discretization);
    if (!discretization.intrinsic)
        return cell_centers(discretization.merging, discretization.points,
                            discretization.input_volumes, k);
    const auto& intrinsic = *discretization.intrinsic;
    const Points points = vertex_points(discretization);
    const Points centers =
        k == 1 ? edge_centers(intrinsic.surface(), points) : triangle_centers(intrinsic, points);
    const SparseMatrix pieces = intrinsic.merging.diamonds.at(k).cast<double>().cwiseAbs();
    const Vector& volumes = intrinsic.triangle_volumes.primal(k);
    const Points weighted = volumes.asDiagonal() * centers;
    return discretization.volumes.primal(k).cwiseInverse().asDiagonal() * (pieces * weighted);
}

Points cell_centroids(const Merging& merging, const Points& points, const CellVolumes& volumes,
                      int k) {
    require_points(merging.input(), points, "a cell's centroid");
    const auto& simplices = merging.input().simplices(k);
    Points centroids = Points::Zero(simplices.rows(), points.cols());
    for (Index s = 0; s < simplices.rows(); ++s)
        for (const Index v : simplices.row(s))
            centroids.row(s) += points.row(v) / (k + 1);
    return mean_over_cells(merging, centroids, volumes, k);
}

} // namespace polydec
