// SPDX-License-Identifier: MIT
#include "dec/merging/facet_defects.h"

#include "base/parallel.h"
#include "dec/merging/facet_links.h"
#include "dec/merging/flat_simplices.h"
#include "dec/metric/circumsphere.h"
#include "dec/metric/simplex_faces.h"
#include "dec/metric/simplex_metric.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>

namespace polydec {

namespace {

using FacetMarks = std::vector<std::uint8_t>;

/// The sums over the m cofaces of a facet of the angles subtended at the apex, compared with m
/// right angles. Their cotangents are the distances of the circumcenters over the circumradius.
FacetMarks measure_angles(const MergeOptions& options, FacetDefects& result) {
    const Pieces& complex = result.geometry.pieces();
    const int n = complex.dimension();
    const Vector radii = circumradii(complex, result.geometry.metric(), n - 1);
    const auto& cofaces = complex.coface_counts(n - 1);
    result.scale.setOnes(radii.size());
    result.defect.setZero(radii.size());
    for_each_height(result.geometry, [&](Index f, double height, double) {
        result.defect[f] += std::atan2(radii[f], height);
    });
    FacetMarks marks;
    for (Index f = 0; f < radii.size(); ++f) {
        double& defect = result.defect[f];
        defect = std::abs(defect - cofaces[f] * std::numbers::pi / 2);
        marks.push_back(radii[f] > 0 && defect <= options.tolerance ? 1 : 0);
    }
    return marks;
}

/// Sizes l of facets, which have an extent if n > 1: twice their circumradii.
class FacetSizes {
public:
    explicit FacetSizes(const Geometry& geometry)
        : k_(geometry.pieces().dimension() - 1),
          layout_(geometry.pieces(), geometry.metric()),
          facets_(geometry.volumes().primal(k_)),
          sides_(geometry.volumes().primal(k_ - 1)),
          lengths_(geometry.volumes().primal(1)),
          faces_(geometry.pieces().faces(k_)),
          edges_(geometry.pieces(), k_, 1) {}

    double operator[](Index f) {
        sphere_.look_at(layout_, k_, f);
        return 2 * sphere_.radius();
    }

    /// An upper bound, faster. Seen from a corner, the center is the sum over the others of half
    /// their squared distance times the gradient of their barycentric coordinate, the inverse
    /// height. So l <= L^2 times the sum of |g| / k |f| over the faces g, L the longest edge.
    double bound(Index f) {
        double sum = 0, edge = 0;
        for (int i = 0; i <= k_; ++i)
            sum += sides_[faces_(f, i)];
        for (const Index e : edges_.of(f))
            edge = std::max(edge, lengths_[e]);
        return edge * edge * sum / (k_ * facets_[f]);
    }

private:
    int k_;
    SimplexLayout layout_;
    Circumsphere sphere_;
    const Vector &facets_, &sides_, &lengths_; // volumes
    FaceTable faces_;
    SimplexFaces edges_;
};

/// Most facets have no defect, or more than their bounds tolerate: only the others need spheres.
FacetMarks measure_duals(const MergeOptions& options, FacetDefects& result) {
    const auto& geometry = result.geometry;
    const int n = geometry.pieces().dimension();
    const Vector& dual = geometry.volumes().dual(n - 1);
    const Bounds& terms = geometry.volumes().terms(n - 1);
    Vector &defect = result.defect, &scale = result.scale;
    FacetMarks marks(static_cast<std::size_t>(dual.size()), 0);
    constexpr double unlimited = std::numeric_limits<double>::infinity();
    const double limit = spread_limit * options.tolerance;
    defect.setZero(dual.size());
    scale.setOnes(dual.size());
    if (geometry.pieces().simplices(n - 1).cols() == 1) // vertices have no extent
        return marks;
    constexpr Index part_size = 1 << 13;
    for_each_part(static_cast<Index>(dual.size()), part_size, [&](Index begin, Index end) {
        FacetSizes sizes(geometry);
        for (Index f = begin; f < end; ++f) {
            defect[f] = std::max(0.0, std::abs(dual[f]) - rounding_of(terms[f]));
            if (defect[f] > 0 && defect[f] <= limit * (scale[f] = sizes.bound(f)))
                scale[f] = sizes[f];
            if (defect[f] <= limit * scale[f] &&
                is_degenerate(dual[f], terms[f], scale[f], unlimited, options.tolerance))
                marks[f] = 1;
        }
    });
    return marks;
}

/// Unmarks the facets of flat n-simplices, and facets whose duals are long beside a height.
void look_at_cofaces(FacetDefects& result, FacetMarks& marks) {
    const Pieces& complex = result.geometry.pieces();
    const CellVolumes& volumes = result.geometry.volumes();
    const int n = complex.dimension();
    const Vector &tops = volumes.primal(n), &facets = volumes.primal(n - 1),
                 &dual = volumes.dual(n - 1);
    const FaceTable faces = complex.faces(n);
    for (Index t = 0; t < tops.size(); ++t) {
        const bool is_flat = !result.flat.empty() && result.flat[t];
        for (int i = 0; i <= n; ++i) {
            const Index f = faces(t, i);
            if (is_flat)
                result.scale[f] = FacetSizes(result.geometry)[f];
            if (marks[f] != 0 && (is_flat || !is_short(dual[f], n * tops[t] / facets[f])))
                marks[f] = 0;
        }
    }
}

} // namespace

double FacetDefects::ratio(Index facet) const {
    const bool by_angles = criterion == MergeCriterion::angle;
    return defect[facet] / (by_angles ? 1 : FacetSizes(geometry)[facet]);
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

FacetDefects facet_defects(const Geometry& geometry, const MergeOptions& options) {
    const bool by_angles = options.criterion == MergeCriterion::angle;
    return facet_defects(geometry, options,
                         by_angles ? std::vector<bool>() : flat_simplices(geometry));
}

FacetDefects facet_defects(const Geometry& geometry, const MergeOptions& options,
                           std::vector<bool> flat) {
    FacetDefects result{geometry, options.criterion, {}, {}, {}, std::move(flat)};
    const bool by_angles = options.criterion == MergeCriterion::angle;
    FacetMarks found = by_angles ? measure_angles(options, result) : measure_duals(options, result);
    if (!by_angles &&
        (!result.flat.empty() || std::find(found.begin(), found.end(), 1) != found.end()))
        look_at_cofaces(result, found);
    auto& [interior, boundary, branching, marks] = result.degenerate;
    const auto& cofaces = geometry.pieces().coface_counts(geometry.pieces().dimension() - 1);
    for (std::size_t f = 0; f < found.size(); ++f)
        if (found[f] != 0)
            ++(cofaces[f] == 1 ? boundary : cofaces[f] == 2 ? interior : branching);
    marks.assign(found.begin(), found.end());
    return result;
}

} // namespace polydec
