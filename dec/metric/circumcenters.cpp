// SPDX-License-Identifier: MIT
#include "base/checks.h"
#include "base/parallel.h"
#include "dec/metric/circumsphere.h"
#include "dec/metric/simplex_geometry.h"
#include "dec/metric/simplex_metric.h"

namespace polydec {

namespace {

/// make() returns the spheres for one thread; refuse(s) throws.
template <class Make, class Refuse>
Vector radii_of(Index count, Make make, Refuse refuse) {
    constexpr Index part_size = 1 << 13;
    Vector radii(count);
    for_each_part(count, part_size, [&](Index begin, Index end) {
        Circumspheres spheres = make();
        for (Index s = begin; s < end; ++s) {
            if (!(spheres[s].volume() > 0))
                refuse(s);
            radii[s] = spheres[s].radius();
        }
    });
    return radii;
}

/// Throws InvalidInput for a vertex without point.
void check_table(const Points& points, const Simplices& simplices) {
    for (const Index vertex : simplices.reshaped())
        check_number("the point", vertex, 0, points.rows() - 1);
}

} // namespace

Vector circumradii(const Points& points, const Simplices& simplices) {
    check_table(points, simplices);
    return radii_of(
        static_cast<Index>(simplices.rows()), [&] { return Circumspheres(points, simplices); },
        [&](Index s) { refuse_circumsphere(vertices(simplices, s)); });
}

Vector circumradii(const Pieces& complex, const SimplexMetric& metric, int k) {
    check_number("circumradii in degree", k, 0, complex.dimension());
    return radii_of(
        complex.size(k), [&] { return Circumspheres(complex, metric, k); },
        [&](Index s) { refuse_circumsphere(complex.vertex_numbers(k, s)); });
}

Points circumcenters(const Points& points, const Simplices& simplices) {
    require_points(points.cols(), "a circumcenter");
    check_table(points, simplices);
    Circumspheres spheres(points, simplices);
    Points centers = Points::Zero(simplices.rows(), points.cols());
    for (Index s = 0; s < simplices.rows(); ++s) {
        if (!(spheres[s].volume() > 0))
            refuse_circumsphere(vertices(simplices, s));
        for (Index i = 0; i < simplices.cols(); ++i)
            centers.row(s) += spheres[s].barycentric(i) * points.row(simplices(s, i));
    }
    return centers;
}

} // namespace polydec
