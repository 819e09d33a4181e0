// SPDX-License-Identifier: MIT
#include "dec/straightness.h"

#include "complex/components.h"
#include "dec/circumsphere.h"
#include "dec/facet_defects.h"
#include "dec/simplex_geometry.h"

#include <algorithm>
#include <cmath>

namespace polydec {

StraightnessTest::StraightnessTest(const SimplicialComplex& complex, const Points& points,
                                   const CellVolumes& volumes, double tolerance)
    : complex_(complex), points_(points), volumes_(volumes), tolerance_(tolerance) {
    if (points.cols() == complex.dimension())
        must_be_coplanar_ = boundary_cells(complex);
}

StraightnessTest::Side StraightnessTest::look(int k, Index s, Index f) const {
    const auto& simplices = complex_.simplices(k);
    int apex = 0;
    while (complex_.face(k, f, apex) != s)
        ++apex;

    Circumsphere sphere(points_);
    sphere.look_at(vertices(simplices, f));
    Side side{sphere.height(apex, volumes_.primal[k - 1][s]), sphere.radius(), {}, 0};

    // the part of the edge to the apex that is orthogonal to s
    const auto& base = complex_.simplices(k - 1).row(s);
    DenseMatrix edges(points_.cols(), k - 1);
    for (int i = 1; i < k; ++i)
        edges.col(i - 1) = (points_.row(base[i]) - points_.row(base[0])).transpose();
    side.away = (points_.row(simplices(f, apex)) - points_.row(base[0])).transpose();
    for (int pass = 0; pass < 2; ++pass) // the second pass removes the rounding of the first
        for (int i = 0; i < k - 1; ++i) {
            for (int j = 0; j < i; ++j)
                edges.col(i) -= edges.col(j) * edges.col(j).dot(edges.col(i));
            edges.col(i).normalize();
            side.away -= edges.col(i) * edges.col(i).dot(side.away);
        }
    side.altitude = side.away.norm();
    side.away /= side.altitude;
    return side;
}

bool StraightnessTest::operator()(int k, Index s, Index f, Index g) const {
    const Side a = look(k, s, f), b = look(k, s, g);
    Circumsphere sphere(points_);
    sphere.look_at(vertices(complex_.simplices(k - 1), s));
    const double l = 2 * sphere.radius();
    const double rounding = dual_length_rounding(std::max(a.radius, b.radius), l);

    if (std::abs(a.height + b.height) > tolerance_ * l + rounding)
        return false;

    const double V = volumes_.dual[k][f], W = volumes_.dual[k][g];
    const double size = std::max({std::abs(V), std::abs(W), std::pow(l, complex_.dimension() - k)});
    if (std::abs(V - W) > (tolerance_ + rounding / l) * size)
        return false;

    if (must_be_coplanar_.empty() || !must_be_coplanar_[k - 1][s])
        return true;
    const double angle_rounding = rounding / std::min(a.altitude, b.altitude);
    return (a.away + b.away).norm() <= tolerance_ + angle_rounding;
}

} // namespace polydec
