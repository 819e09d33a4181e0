// SPDX-License-Identifier: MIT
#include "dec/facet_defects.h"

#include "dec/circumsphere.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace polydec {

namespace {

using Row = IncidenceMatrix::InnerIterator;

/// Per facet, the sum over its cofaces of the angle under which they see it, from the apex: the
/// cotangent is the signed distance of the circumcenters over the facet's circumradius.
Vector apex_angles(const SimplicialComplex& complex, const SimplexMetric& metric,
                   const CellVolumes& volumes, const Vector& radii) {
    const int n = complex.dimension();
    Vector angles = Vector::Zero(complex.size(n - 1));
    SimplexLayout layout(complex, metric);
    Circumsphere sphere;
    for (Index t = 0; t < complex.size(n); ++t) {
        sphere.look_at(layout.at(n, t));
        for (int i = 0; i <= n; ++i) {
            const Index f = complex.face(n, t, i);
            angles[f] += std::atan2(radii[f], sphere.height(i, volumes.primal(n - 1)[f]));
        }
    }
    return angles;
}

FacetDefects angle_defects(const SimplicialComplex& complex, const SimplexMetric& metric,
                           const CellVolumes& volumes, const Vector& radii, double tolerance) {
    const int n = complex.dimension();
    FacetDefects result{apex_angles(complex, metric, volumes, radii),
                        Vector::Ones(complex.size(n - 1)), std::vector<bool>(complex.size(n - 1))};
    for (Index f = 0; f < complex.size(n - 1); ++f) {
        const double right_angles = complex.coface_counts(n - 1)[f] * std::numbers::pi / 2;
        result.defect[f] = std::abs(result.defect[f] - right_angles);
        result.degenerate[f] = radii[f] > 0 && result.defect[f] <= tolerance;
    }
    return result;
}

FacetDefects length_defects(const SimplicialComplex& complex, const SimplexMetric& metric,
                            const CellVolumes& volumes, const Vector& radii, double tolerance) {
    const int n = complex.dimension();
    FacetDefects result{volumes.dual(n - 1).cwiseAbs(), 2 * radii,
                        std::vector<bool>(complex.size(n - 1), false)};
    Vector largest = Vector::Zero(complex.size(n - 1));
    const Vector top_radii = circumradii(complex, metric, n);
    for (Index t = 0; t < complex.size(n); ++t)
        for (Row f(complex.coboundary(n - 1), t); f; ++f)
            largest[f.col()] = std::max(largest[f.col()], top_radii[t]);
    for (Index f = 0; f < complex.size(n - 1); ++f) {
        const double l = result.scale[f];
        if (!(l > 0))
            continue;
        result.defect[f] = std::max(0.0, result.defect[f] - dual_length_rounding(largest[f], l));
        result.degenerate[f] = result.defect[f] <= tolerance * l;
    }
    return result;
}

} // namespace

double dual_length_rounding(double circumradius, double length) {
    const double shape = circumradius / length;
    return 64 * std::numeric_limits<double>::epsilon() * shape * shape * length;
}

FacetDefects facet_defects(const SimplicialComplex& complex, const SimplexMetric& metric,
                           const CellVolumes& volumes, const MergeOptions& options) {
    const Vector radii = circumradii(complex, metric, complex.dimension() - 1);
    return options.criterion == MergeCriterion::angle
               ? angle_defects(complex, metric, volumes, radii, options.tolerance)
               : length_defects(complex, metric, volumes, radii, options.tolerance);
}

} // namespace polydec
