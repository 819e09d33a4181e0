// SPDX-License-Identifier: MIT
#pragma once

#include "dec/metric/simplex_layout.h"
#include "dec/metric/sphere_kernel.h"

#include <cmath>
#include <tuple>
#include <vector>

namespace polydec {

/// Volume and circumsphere of one simplex at a time, of any dimension k in R^N. Orthogonalizes the
/// edge vectors, for flat simplices with twice the digits of a double. So volume, radius and all
/// barycentric coordinates but the largest are correct to the last few digits, unless two heights
/// together are 1e-16 of the edges; rounding() estimates the error. Members that need a sphere
/// throw InvalidInput for a simplex without volume, and before the first look_at.
class Circumsphere {
public:
    /// Looks at the simplex with these k+1 corners; throws InvalidInput unless there are 1 to 32.
    /// Returns false iff the edge vectors are linearly dependent to the last digit: then volume()
    /// is 0 and there is no sphere.
    [[nodiscard]] bool look_at(const Corners& corners);

    /// Looks at k-simplex s of the layout's complex. Throws InvalidInput, naming its vertices, if
    /// it has no volume.
    void look_at(SimplexLayout& layout, int k, Index s);

    /// k-dimensional volume, length^k; 1 for a vertex.
    double volume() const { return sphere_.volume; }

    /// Circumradius; 0 for a vertex.
    double radius() const {
        check_sphere();
        return std::sqrt(sphere_.squared_radius);
    }

    /// Barycentric coordinate of the circumcenter at the i-th vertex; negative where the center
    /// lies beyond the opposite facet.
    double barycentric(int i) const {
        check_sphere();
        return sphere_.barycentric[i];
    }

    /// The coordinates at all vertices; valid until the next look_at.
    const double* barycentric() const {
        check_sphere();
        return sphere_.barycentric.data();
    }

    /// Signed distance from the circumcenter of the facet opposite to the i-th vertex to the
    /// simplex's circumcenter, positive towards that vertex: barycentric coordinate times height.
    double height(int i, double facet_volume) const {
        return barycentric(i) * dimension_ * volume() / facet_volume;
    }

    /// Scale of the error of such a height (see rounding_of) if the last digits of the input are
    /// uncertain. The shift bounds, to first order, how far the center moves if every corner moves
    /// by its largest coordinate x: 2 R x / a, with 1/a^2 the sum of the inverse squared heights of
    /// the corners. For given distances d, the shift is the sum of d_ij^2 |b_j| / a_i, with b the
    /// barycentric coordinates of the center, and heights grow by 1 + sum of d_ij^2 / (2 a_i a_j).
    const HeightTerms& uncertainty() const { return sphere_.uncertainty; }

    /// The same for exact points: rounding errors of the computation. Edges of length l shift the
    /// center by R l / a; volumes and heights grow by 1 + l / a. Random simplices of dimensions 1
    /// to 5 had errors of at most .4 times rounding_of this. With twice the digits, (l / a)^2 eps
    /// replaces l / a. Computed points count as SimplexMetric::error off.
    const HeightTerms& rounding() const { return sphere_.rounding; }

private:
    template <class Number, int k_fixed, int N_fixed>
    void look(int k, int N, const double* const* corners, double error);
    void check_sphere() const {
        if (!(volume() > 0))
            refuse_flat();
    }
    [[noreturn]] static void refuse_flat();

    int dimension_ = 0;
    SphereOf<double> sphere_;
    std::tuple<std::vector<double>, std::vector<TwoDoubles>> rooms_;
};

} // namespace polydec
