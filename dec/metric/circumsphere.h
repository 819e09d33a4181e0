// SPDX-License-Identifier: MIT
#pragma once

#include "dec/metric/pack.h"
#include "dec/metric/simplex_layout.h"
#include "dec/metric/two_doubles.h"

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

namespace polydec {

/// Scale of the rounding error of a signed circumcentric distance h.
struct HeightTerms {
    double growth = 1, shift = 0;

    double of(double height) const { return growth * std::abs(height) + shift; }
};

/// Volume and circumsphere of one simplex at a time, of any dimension k in R^N. Orthogonalizes the
/// edge vectors, for flat simplices with twice the digits of a double. So volume, radius and all
/// barycentric coordinates but the largest are correct to the last few digits, unless two heights
/// together are 1e-16 of the edges; rounding() estimates the error. Members that need a sphere
/// throw InvalidInput for a simplex without volume, and before the first look_at.
class Circumsphere {
public:
    /// For simplices whose corners are placed by a SimplexLayout.
    Circumsphere() = default;

    /// For simplices between these points, which must outlive this object.
    explicit Circumsphere(const Points& points) : points_(&points) {}

    /// Looks at the simplex with these k+1 vertex numbers; throws InvalidInput unless there are 1
    /// to 32. Returns false iff the edge vectors are linearly dependent to the last digit: then
    /// volume() is 0 and there is no sphere.
    [[nodiscard]] bool look_at(std::span<const Index> vertices);
    [[nodiscard]] bool look_at(const Corners& corners);

    /// Looks at k-simplex s of the layout's complex. Throws InvalidInput, naming its vertices, if
    /// it has no volume.
    void look_at(SimplexLayout& layout, int k, Index s);

    /// k-dimensional volume, length^k; 1 for a vertex.
    double volume() const { return volume_; }

    /// Circumradius; 0 for a vertex.
    double radius() const {
        check_sphere();
        return std::sqrt(squared_radius_);
    }

    /// Barycentric coordinate of the circumcenter at the i-th vertex; negative where the center
    /// lies beyond the opposite facet.
    double barycentric(int i) const {
        check_sphere();
        return barycentric_[i];
    }

    /// The coordinates at all vertices; valid until the next look_at.
    const double* barycentric() const {
        check_sphere();
        return barycentric_.data();
    }

    /// Signed distance from the circumcenter of the facet opposite to the i-th vertex to the
    /// simplex's circumcenter, positive towards that vertex: barycentric coordinate times height.
    double height(int i, double facet_volume) const {
        return barycentric(i) * dimension_ * volume_ / facet_volume;
    }

    /// Scale of the error of such a height (see rounding_of) if the last digits of the input are
    /// uncertain. The shift bounds, to first order, how far the center moves if every corner moves
    /// by its largest coordinate x: 2 R x / a, with 1/a^2 the sum of the inverse squared heights of
    /// the corners. For given distances d, the shift is the sum of d_ij^2 |b_j| / a_i, with b the
    /// barycentric coordinates of the center, and heights grow by 1 + sum of d_ij^2 / (2 a_i a_j).
    const HeightTerms& uncertainty() const { return uncertainty_; }

    /// The same for exact points: rounding errors of the computation. Edges of length l shift the
    /// center by R l / a; volumes and heights grow by 1 + l / a. Random simplices of dimensions 1
    /// to 5 had errors of at most .4 times rounding_of this. With twice the digits, (l / a)^2 eps
    /// replaces l / a.
    const HeightTerms& rounding() const { return rounding_; }

private:
    friend class Circumspheres;

    template <class Number, int k_fixed, int N_fixed>
    static void look(Circumsphere* spheres, int k, int N, const double* const* corners);
    template <class Number>
    static void look(Circumsphere* spheres, int k, int N, const double* const* corners);
    template <class Number, int N_fixed>
    static void look_at_edges(Circumsphere* spheres, int N, const double* const* corners);
    void measure_distances(const Corners& corners);
    void check_sphere() const {
        if (!(volume_ > 0))
            refuse_flat();
    }
    [[noreturn]] static void refuse_flat();

    const Points* points_ = nullptr;
    static constexpr int most_vertices = 32; // of a simplex of a complex, too
    std::array<double, most_vertices> barycentric_{};
    std::array<double, most_vertices> squared_slopes_{}; // of the coordinates: 1 / height^2
    std::tuple<std::vector<double>, std::vector<Pack>, std::vector<TwoDoubles>> scratch_;
    int dimension_ = 0;
    double volume_ = 0;
    double squared_radius_ = 0;
    HeightTerms uncertainty_, rounding_;
};

/// Circumspheres of simplices requested in ascending order; computes several at once. Not
/// thread-safe.
class Circumspheres {
public:
    /// Of the k-simplices of a complex, or of simplices between points. Keeps references.
    Circumspheres(const Pieces& complex, const SimplexMetric& metric, int k)
        : points_(metric.points()), simplices_(complex.simplices(k)) {
        if (!points_)
            layout_.emplace(complex, metric);
    }
    Circumspheres(const Points& points, const Simplices& simplices)
        : points_(&points), simplices_(simplices) {}

    /// The sphere of simplex s, valid until the next call; its volume is 0 if there is no sphere.
    const Circumsphere& operator[](Index s) {
        if (s < first_ || s >= first_ + count_)
            look_from(s);
        return spheres_[s - first_];
    }

private:
    void look_from(Index s);

    const Points* points_; // null: by the layout
    const Simplices& simplices_;
    std::optional<SimplexLayout> layout_;
    std::array<Circumsphere, Pack::size> spheres_;
    Index first_ = 0, count_ = 0;
};

/// Throws InvalidInput: a simplex with these vertices has no circumsphere.
[[noreturn]] void refuse_circumsphere(std::span<const Index> vertices);

} // namespace polydec
