// SPDX-License-Identifier: MIT
#include "base/checks.h"
#include "base/parallel.h"
#include "dec/metric/circumsphere.h"
#include "dec/metric/simplex_geometry.h"
#include "dec/metric/simplex_metric.h"

namespace polydec {

namespace {

/// make() returns what places the corners of a simplex, for one thread; refuse(s) throws.
template <class Make, class Refuse>
Vector radii_of(Index count, Make make, Refuse refuse) {
    constexpr Index part_size = 1 << 13;
    Vector radii(count);
    for_each_part(count, part_size, [&](Index begin, Index end) {
        auto corners = make();
        Circumsphere sphere;
        for (Index s = begin; s < end; ++s) {
            if (!sphere.look_at(corners(s)))
                refuse(s);
            radii[s] = sphere.radius();
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
    const auto corners = [&](Index s) { return Corners{points, vertices(simplices, s)}; };
    return radii_of(
        static_cast<Index>(simplices.rows()), [&] { return corners; },
        [&](Index s) { refuse_circumsphere(vertices(simplices, s)); });
}

Vector circumradii(const Pieces& complex, const SimplexMetric& metric, int k) {
    check_number("circumradii in degree", k, 0, complex.dimension());
    return radii_of(
        complex.size(k),
        [&] {
            return [layout = SimplexLayout(complex, metric), k](Index s) mutable {
                return layout.at(k, s);
            };
        },
        [&](Index s) { refuse_circumsphere(complex.vertex_numbers(k, s)); });
}

Points circumcenters(const Points& points, const Simplices& simplices) {
    require_points(points.cols(), "a circumcenter");
    check_table(points, simplices);
    Circumsphere sphere(points);
    Points centers = Points::Zero(simplices.rows(), points.cols());
    for (Index s = 0; s < simplices.rows(); ++s) {
        if (!sphere.look_at(vertices(simplices, s)))
            refuse_circumsphere(vertices(simplices, s));
        for (int i = 0; i < simplices.cols(); ++i)
            centers.row(s) += sphere.barycentric(i) * points.row(simplices(s, i));
    }
    return centers;
}

} // namespace polydec
