// SPDX-License-Identifier: MIT
#include "dec/merging/straightness.h"

#include "dec/merging/facet_defects.h"
#include "dec/metric/rounding.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

namespace polydec {

StraightnessTest::StraightnessTest(const Geometry& geometry, double tolerance, double angle)
    : geometry_(geometry),
      complex_(geometry_.pieces()),
      tolerance_(tolerance),
      angle_(angle),
      layout_(complex_, geometry_.metric()),
      heights_(complex_.dimension(), geometry_.metric().ambient_dimension()) {
    const CellVolumes& volumes = geometry_.volumes();
    for (int k = 1; k <= complex_.dimension(); ++k)
        degrees_.push_back(
            {complex_.faces(k), volumes.primal(k), volumes.dual(k), volumes.terms(k)});
    const int n = complex_.dimension();
    if (n < 3)
        return;
    on_boundary_ = boundary_cells(complex_);
    if (geometry_.metric().ambient_dimension() == n)
        return;
    SimplexFaces ridges(complex_, n, n - 2);
    DenseMatrix angles = DenseMatrix::Zero(complex_.size(n), std::ssize(ridges.positions()));
    for_each_angle(complex_, geometry_.metric(), {},
                   [&](Index t, Index i, Index, double radians) { angles(t, i) = radians; });
    angles_.emplace(Angles{std::move(ridges), std::move(angles), Cofaces(complex_, n)});
}

StraightnessTest::Wing StraightnessTest::look(int k, Index s, Index f) {
    int apex = 0;
    while (degrees_[k - 1].faces(f, apex) != s)
        ++apex;
    sphere_.look_at(layout_, k, f);
    const double base = degrees_[k - 2].primal[s], height = sphere_.height(apex, base);
    return {complex_.simplices(k)(f, apex), height, sphere_.uncertainty().of(height),
            k * degrees_[k - 1].primal[f] / base};
}

bool StraightnessTest::is_unfolded(Index s, Index f, Index g, double limit) {
    auto& [ridges, angles, cofaces] = *angles_;
    for (Coface at : cofaces.of(f)) {
        double sum = 0;
        Index facet = f;
        do {
            const auto& list = ridges.of(at.cell);
            const auto i = std::find(list.begin(), list.end(), s) - list.begin();
            sum += angles(at.cell, i);
            const auto& corners = ridges.omitted()[i]; // each is lacking in a facet around s
            facet = degrees_.back().faces(at.cell, corners[corners[0] == at.omitted ? 1 : 0]);
            const auto sides = cofaces.of(facet);
            if (facet != g && sides.size() != 2)
                return false;
            at = sides.front().cell == at.cell ? sides.back() : sides.front();
        } while (facet != f && facet != g);
        if (facet != g || std::abs(sum - std::numbers::pi) > limit)
            return false;
    }
    return true;
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

    const double angle = on_boundary_[k - 1][s] ? angle_ : tolerance_;
    const double limit = angle + rounding_of(terms) / lower;
    if (angles_)
        return k < complex_.dimension() - 1 || is_unfolded(s, f, g, limit);
    const auto& points = *geometry_.metric().points(); // a flat complex in R^N has points
    const double bend =
        heights_.over(vertices(complex_.simplices(k - 1), s), {a.apex, b.apex}, points).sum;
    return bend <= limit;
}

} // namespace polydec
