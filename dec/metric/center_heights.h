// SPDX-License-Identifier: MIT
#pragma once

#include "dec/metric/centers.h"
#include "dec/metric/circumsphere.h"

namespace polydec {

/// Where the centers of single simplices lie: their heights over facets, and how certain these are.
class CenterHeights {
public:
    explicit CenterHeights(const Centers& centers) : kind_(centers.kind_), given_(centers.given_) {}

    /// Whether the centers of k-simplices are known without a sphere; such simplices may be flat.
    bool know(int k) const { return kind_ == Kind::of_cells && k == given_->front().cols() - 1; }

    bool are_circumcenters(int k) const {
        return kind_ == Kind::circumcenters || (kind_ == Kind::of_cells && !know(k));
    }

    /// For each corner, the signed distance from the facet without it to the center of k-simplex s,
    /// positive towards the corner, times the volume of the facet: these numbers times the factor.
    /// The sphere must have looked at s.
    struct Moments {
        const double* numbers;
        double factor;
    };
    Moments moments(int k, Index s, const Circumsphere& sphere) const {
        if (know(k))
            return {&given_->front()(s, 0), 1};
        const double factor = k * sphere.volume();
        return are_circumcenters(k)
                   ? Moments{sphere.barycentric(), factor}
                   : Moments{&(*given_)[k](kind_ == Kind::centroids ? 0 : s, 0), factor};
    }

    /// Coordinate of the center of k-simplex s at corner i; the sphere must have looked at s. The
    /// centroid's for an n-simplex without volume that shares its center: it has weight zero.
    double coordinate(int k, Index s, int i, const Circumsphere& sphere) const {
        return know(k) ? shared_coordinate(s, i) : moments(k, s, sphere).numbers[i];
    }

    /// Scale of the errors of heights in k-simplex s; the sphere must have looked at s. Given
    /// centers do not move when corners do.
    HeightTerms uncertainty(int k, Index s, const Circumsphere& sphere) const {
        return terms(k, s, sphere.uncertainty(), 0);
    }
    HeightTerms rounding(int k, Index s, const Circumsphere& sphere) const {
        return terms(k, s, sphere.rounding(), 2);
    }

private:
    using Kind = Centers::Kind;

    HeightTerms terms(int k, Index s, const HeightTerms& of_sphere, int column) const {
        if (know(k))
            return {given_->back()(s, column), given_->back()(s, column + 1)};
        return are_circumcenters(k) ? of_sphere : HeightTerms{of_sphere.growth, 0};
    }
    double shared_coordinate(Index s, int i) const;

    Kind kind_;
    std::shared_ptr<const std::vector<Points>> given_;
};

} // namespace polydec
