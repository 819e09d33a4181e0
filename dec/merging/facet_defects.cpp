// SPDX-License-Identifier: MIT
#include "dec/merging/facet_defects.h"

#include "dec/metric/circumsphere.h"
#include "dec/metric/rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace polydec {

namespace {

/// Per facet, the sum over its cofaces of the angle under which they see it, from the apex: the
/// cotangent is the signed distance of the circumcenters over the facet's circumradius.
Vector apex_angles(const Pieces& complex, const SimplexMetric& metric, const CellVolumes& volumes,
                   const Vector& radii) {
    const int n = complex.dimension();
    Vector angles = Vector::Zero(complex.size(n - 1));
    SimplexLayout layout(complex, metric);
    Circumsphere sphere;
    for (Index t = 0; t < complex.size(n); ++t) {
        sphere.look_at(layout, n, t);
        for (int i = 0; i <= n; ++i) {
            const Index f = complex.face(n, t, i);
            angles[f] += std::atan2(radii[f], sphere.height(i, volumes.primal(n - 1)[f]));
        }
    }
    return angles;
}

/// Where only a tolerance is still missing.
FacetDefects length_defects(const CellVolumes& volumes, int degree, Vector scale, Vector height,
                            double tolerance) {
    const Vector &dual = volumes.dual(degree), &terms = volumes.terms(degree);
    FacetDefects result{dual.cwiseAbs(), std::move(scale), std::move(height),
                        std::vector<bool>(static_cast<std::size_t>(dual.size()), false)};
    for (Index f = 0; f < dual.size(); ++f) {
        result.defect[f] = std::max(0.0, result.defect[f] - rounding_of(terms[f]));
        result.degenerate[f] =
            is_degenerate(dual[f], terms[f], result.scale[f], result.height[f], tolerance);
    }
    return result;
}

/// Least height n |t| / |f| of the n-simplices over each facet.
Vector least_heights(const Pieces& complex, const CellVolumes& volumes) {
    const int n = complex.dimension();
    Vector heights = Vector::Constant(complex.size(n - 1), std::numeric_limits<double>::infinity());
    for (Index t = 0; t < complex.size(n); ++t)
        for (int i = 0; i <= n; ++i) {
            const Index f = complex.face(n, t, i);
            heights[f] = std::min(heights[f], n * volumes.primal(n)[t] / volumes.primal(n - 1)[f]);
        }
    return heights;
}

} // namespace

bool is_degenerate(double dual, double terms, double l, double height, double tolerance) {
    constexpr double thin = 0.1; // of a height
    return l > 0 && std::abs(dual) <= tolerance * l + rounding_of(terms) &&
           std::abs(dual) <= thin * height;
}

FacetDefects facet_defects(const Pieces& complex, const SimplexMetric& metric,
                           const CellVolumes& volumes, const MergeOptions& options) {
    const int n = complex.dimension();
    const Vector radii = circumradii(complex, metric, n - 1);
    auto result = length_defects(volumes, n - 1, 2 * radii, least_heights(complex, volumes),
                                 options.tolerance);
    if (options.criterion != MergeCriterion::angle)
        return result;
    result.defect = apex_angles(complex, metric, volumes, radii);
    result.scale.setOnes();
    for (Index f = 0; f < complex.size(n - 1); ++f) {
        const double right_angles = complex.coface_counts(n - 1)[f] * std::numbers::pi / 2;
        result.defect[f] = std::abs(result.defect[f] - right_angles);
        result.degenerate[f] = radii[f] > 0 && result.defect[f] <= options.tolerance;
    }
    return result;
}

} // namespace polydec
