// SPDX-License-Identifier: MIT
#include "dec/merging/facet_defects.h"

#include "dec/merging/flat_simplices.h"
#include "dec/metric/circumcenters.h"
#include "dec/metric/circumsphere.h"
#include "dec/metric/rounding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace polydec {

namespace {

/// Per facet, the sum over its cofaces of the angle subtended at the apex: the cotangent is the
/// signed distance of the circumcenters over the facet's circumradius.
Vector apex_angles(const Geometry& geometry, const Vector& radii) {
    Vector angles = Vector::Zero(radii.size());
    for_each_height(geometry, [&](Index f, double height, double) {
        angles[f] += std::atan2(radii[f], height);
    });
    return angles;
}

/// Marks the facets of flat simplices.
std::vector<bool> facets_of(const Pieces& complex, const std::vector<bool>& flat) {
    const int n = complex.dimension();
    std::vector<bool> marks(static_cast<std::size_t>(complex.size(n - 1)), false);
    for (std::size_t t = 0; t < flat.size(); ++t)
        for (int i = 0; i <= n && flat[t]; ++i)
            marks[complex.face(n, static_cast<Index>(t), i)] = true;
    return marks;
}

} // namespace

bool is_degenerate(double dual, double terms, double l, double height, double tolerance) {
    constexpr double thin = 0.1; // of a height
    return l > 0 && std::abs(dual) <= tolerance * l + rounding_of(terms) &&
           std::abs(dual) <= thin * height;
}

void for_each_height(const Geometry& geometry,
                     const std::function<void(Index, double, double)>& take) {
    const Pieces& complex = geometry.pieces();
    const int n = complex.dimension();
    const Vector& facets = geometry.volumes().primal(n - 1);
    SimplexLayout layout(complex, geometry.metric());
    Circumsphere sphere;
    for (Index t = 0; t < complex.size(n); ++t) {
        if (!sphere.look_at(layout.at(n, t)))
            continue;
        for (int i = 0; i <= n; ++i) {
            const Index f = complex.face(n, t, i);
            const double height = sphere.height(i, facets[f]);
            take(f, height, sphere.uncertainty().of(height));
        }
    }
}

Vector least_heights(const Pieces& complex, const CellVolumes& volumes,
                     const std::vector<bool>& flat) {
    const int n = complex.dimension();
    const FaceTable faces = complex.faces(n);
    const Vector &tops = volumes.primal(n), &facets = volumes.primal(n - 1);
    Vector heights = Vector::Constant(facets.size(), std::numeric_limits<double>::infinity());
    for (Index t = 0; t < tops.size(); ++t)
        for (int i = 0; i <= n && (flat.empty() || !flat[t]); ++i) {
            const Index f = faces(t, i);
            heights[f] = std::min(heights[f], n * tops[t] / facets[f]);
        }
    return heights;
}

FacetDefects facet_defects(const Geometry& geometry, const MergeOptions& options) {
    const bool by_angles = options.criterion == MergeCriterion::angle;
    return facet_defects(geometry, options,
                         by_angles ? std::vector<bool>() : flat_simplices(geometry));
}

FacetDefects facet_defects(const Geometry& geometry, const MergeOptions& options,
                           std::vector<bool> flat) {
    const Pieces& complex = geometry.pieces();
    const CellVolumes& volumes = geometry.volumes();
    const int n = complex.dimension();
    const bool by_angles = options.criterion == MergeCriterion::angle;
    const Vector& dual = volumes.dual(n - 1);
    const Bounds& terms = volumes.terms(n - 1);
    FacetDefects result;
    result.scale = circumradii(complex, geometry.metric(), n - 1);
    result.defect = by_angles ? apex_angles(geometry, result.scale) : dual;
    const auto& cofaces = complex.coface_counts(n - 1);
    auto& [interior, boundary, branching, marks] = result.degenerate;
    marks.resize(static_cast<std::size_t>(dual.size()));
    constexpr double unlimited = std::numeric_limits<double>::infinity();
    bool any = false;
    for (Index f = 0; f < dual.size(); ++f) {
        double &defect = result.defect[f], &scale = result.scale[f];
        const bool has_extent = scale > 0;
        defect = by_angles ? std::abs(defect - cofaces[f] * std::numbers::pi / 2)
                           : std::max(0.0, std::abs(defect) - rounding_of(terms[f]));
        scale = by_angles ? 1 : 2 * scale;
        marks[f] = by_angles
                       ? has_extent && defect <= options.tolerance
                       : is_degenerate(dual[f], terms[f], scale, unlimited, options.tolerance);
        any = any || marks[f];
    }
    result.flat = std::move(flat);
    if (!any)
        return result;

    const auto of_flat = facets_of(complex, result.flat);
    const Vector heights = by_angles ? Vector() : least_heights(complex, volumes, result.flat);
    for (Index f = 0; f < dual.size(); ++f) {
        marks[f] = marks[f] &&
                   (by_angles || (!of_flat[f] && is_degenerate(dual[f], terms[f], result.scale[f],
                                                               heights[f], options.tolerance)));
        if (marks[f])
            ++(cofaces[f] == 1 ? boundary : cofaces[f] == 2 ? interior : branching);
    }
    return result;
}

} // namespace polydec
