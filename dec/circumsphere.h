// SPDX-License-Identifier: MIT
#pragma once

#include "dec/simplex_metric.h"
#include "dec/two_doubles.h"

#include <array>
#include <cmath>
#include <span>
#include <tuple>
#include <vector>

namespace polydec {

/// Volume and circumscribed sphere of one simplex after another, of any dimension k in R^N. Works
/// by orthogonalizing the edge vectors, of flat simplices with twice the digits of a double, so
/// that volume, radius and barycentric coordinates (beside the largest of them) are right to the
/// last few digits whatever the shape.
class Circumsphere {
public:
    /// For simplices whose corners a SimplexLayout places.
    Circumsphere() = default;

    /// For simplices between these points, which must outlive it.
    explicit Circumsphere(const Points& points) : points_(&points) {}

    /// Looks at the simplex with these k+1 vertex numbers. False iff its edge vectors are linearly
    /// dependent to the last digit; volume() is 0 then and nothing else may be asked.
    bool look_at(std::span<const Index> vertices);
    bool look_at(const Corners& corners) {
        points_ = &corners.points;
        return look_at(corners.vertices);
    }

    /// k-dimensional volume, length^k; 1 for a vertex.
    double volume() const { return volume_; }

    /// Circumradius; 0 for a vertex.
    double radius() const { return std::sqrt(squared_radius_); }

    /// Barycentric coordinate of the circumcenter at the i-th vertex; negative where the center
    /// lies beyond the opposite facet.
    double barycentric(int i) const { return barycentric_[i]; }

    /// Signed distance from the circumcenter of the facet opposite to the i-th vertex to the
    /// simplex's own, positive towards that vertex: barycentric coordinate times height.
    double height(int i, double facet_volume) const {
        return barycentric_[i] * dimension_ * volume_ / facet_volume;
    }

private:
    template <class Number, int k_fixed, int N_fixed>
    bool look(std::span<const Index> vertices);

    const Points* points_ = nullptr;
    std::array<double, 32> barycentric_{}; // more vertices no simplex of a complex has
    std::tuple<std::vector<double>, std::vector<TwoDoubles>> scratch_;
    int dimension_ = 0;
    double volume_ = 0;
    double squared_radius_ = 0;
};

/// Circumradii of all k-simplices in the given table (rows of vertex numbers).
Vector circumradii(const Points& points, const Simplices& simplices);

/// Circumradii of all k-simplices of the complex.
Vector circumradii(const SimplicialComplex& complex, const SimplexMetric& metric, int k);

/// Circumcenters of all k-simplices in the given table: one row of N coordinates each.
Points circumcenters(const Points& points, const Simplices& simplices);

} // namespace polydec
