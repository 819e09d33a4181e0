// SPDX-License-Identifier: MIT
#include "dec/merging/straightness.h"

#include "complex/components.h"
#include "dec/merging/facet_defects.h"
#include "dec/metric/angle_sums.h"
#include "dec/metric/rounding.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace polydec {

StraightnessTest::StraightnessTest(const Geometry& geometry, double tolerance, double angle)
    : geometry_(geometry),
      complex_(geometry_.pieces()),
      tolerance_(tolerance),
      angle_(angle),
      layout_(complex_, geometry_.metric()) {
    const CellVolumes& volumes = geometry_.volumes();
    for (int k = 1; k <= complex_.dimension(); ++k)
        degrees_.push_back(
            {complex_.faces(k), volumes.primal(k), volumes.dual(k), volumes.terms(k)});
    is_flat_ = geometry_.metric().ambient_dimension() == complex_.dimension();
    if (complex_.dimension() > 2)
        must_be_coplanar_ = boundary_cells(complex_);
    if (!must_be_coplanar_.empty() && !is_flat_)
        angles_ = angle_sums(complex_, geometry_.metric());
}

StraightnessTest::Wing StraightnessTest::look(int k, Index s, Index f) {
    int apex = 0;
    while (degrees_[k - 1].faces(f, apex) != s)
        ++apex;
    sphere_.look_at(layout_, k, f);
    const double base = degrees_[k - 2].primal[s], height = sphere_.height(apex, base);
    return {apex, height, sphere_.uncertainty().of(height), k * degrees_[k - 1].primal[f] / base};
}

Vector StraightnessTest::upwards(int k, Index s, Index f, int apex) const {
    const auto& base = complex_.simplices(k - 1).row(s);
    const Points& points = *geometry_.metric().points(); // a flat complex in R^N has points
    DenseMatrix edges(points.cols(), k - 1);
    for (int i = 1; i < k; ++i)
        edges.col(i - 1) = (points.row(base[i]) - points.row(base[0])).transpose();
    Vector away = (points.row(complex_.simplices(k)(f, apex)) - points.row(base[0])).transpose();
    for (int pass = 0; pass < 2; ++pass) // the second pass removes the rounding of the first
        for (int i = 0; i < k - 1; ++i) {
            for (int j = 0; j < i; ++j)
                edges.col(i) -= edges.col(j) * edges.col(j).dot(edges.col(i));
            edges.col(i).normalize();
            away -= edges.col(i) * edges.col(i).dot(away);
        }
    return away / away.norm();
}

bool StraightnessTest::operator()(int k, Index s, Index f, Index g) {
    const Wing a = look(k, s, f), b = look(k, s, g);
    sphere_.look_at(layout_, k - 1, s);
    const double l = 2 * sphere_.radius(), terms = a.terms + b.terms;
    const double lower = std::min(a.altitude, b.altitude);
    if (!is_degenerate(a.height + b.height, terms, l, lower, tolerance_))
        return false;

    const auto& [faces, primal, dual, cancel] = degrees_[k - 1];
    const double V = dual[f], W = dual[g];
    double size = 1; // of a dual
    for (int i = k; i < complex_.dimension(); ++i)
        size *= l;
    size = std::max({std::abs(V), std::abs(W), size});
    const double noise = rounding_of(cancel[f] + cancel[g]);
    if (std::abs(V - W) > tolerance_ * size + noise)
        return false;

    if (must_be_coplanar_.empty() || !must_be_coplanar_[k - 1][s])
        return true;
    const double angle_rounding = rounding_of(terms) / lower;
    if (!is_flat_)
        return k < complex_.dimension() - 1 ||
               std::abs(angles_[s] - std::numbers::pi) <= angle_ + angle_rounding;
    return (upwards(k, s, f, a.apex) + upwards(k, s, g, b.apex)).norm() <= angle_ + angle_rounding;
}

} // namespace polydec
