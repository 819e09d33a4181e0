// SPDX-License-Identifier: MIT
#pragma once

#include "dec/metric/pack.h"
#include "dec/metric/simplex_metric.h"
#include "dec/metric/two_doubles.h"

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

namespace polydec {

/// What errors of a signed distance h between circumcenters are in proportion to.
struct HeightTerms {
    double growth = 1, shift = 0;

    double of(double height) const { return growth * std::abs(height) + shift; }
};

/// Volume and circumscribed sphere of one simplex after another, of any dimension k in R^N. Works
/// by orthogonalizing the edge vectors, of flat simplices with twice the digits of a double, so
/// that volume, radius and barycentric coordinates (beside the largest of them) are right to the
/// last few digits unless two heights together are 1e-16 of the edges; rounding() tells. What is
/// asked of the sphere of a simplex without volume, or before any, throws InvalidInput.
class Circumsphere {
public:
    /// For simplices whose corners a SimplexLayout places.
    Circumsphere() = default;

    /// For simplices between these points, which must outlive it.
    explicit Circumsphere(const Points& points) : points_(&points) {}

    /// Looks at the simplex with these k+1 vertex numbers, 1 to 32 of them or else InvalidInput is
    /// thrown. False iff its edge vectors are linearly dependent to the last digit; volume() is 0
    /// then, and there is no sphere.
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

    /// Those of all vertices, until it looks at another simplex.
    const double* barycentric() const {
        check_sphere();
        return barycentric_.data();
    }

    /// Signed distance from the circumcenter of the facet opposite to the i-th vertex to the
    /// simplex's own, positive towards that vertex: barycentric coordinate times height.
    double height(int i, double facet_volume) const {
        return barycentric(i) * dimension_ * volume_ / facet_volume;
    }

    /// To what the error of such a height is in proportion (see rounding_of) if the last digits of
    /// what is given are not known. The shift is how far the center moves, to first order, if every
    /// corner moves by the size x of its largest coordinate: 2 R x / a, a the heights of the
    /// corners, whose inverse squares add up. Where distances d are given: sum of d_ij^2 |b_j| /
    /// a_i with the barycentric coordinates b of the center; heights grow by 1 + sum of d_ij^2 / (2
    /// a_i a_j) then.
    const HeightTerms& uncertainty() const { return uncertainty_; }

    /// The same for points that are exact: what computing has done. Edges of length l shift the
    /// center by R l / a, and volumes, and heights with them, grow by 1 + l / a. Random
    /// simplices of dimensions 1 to 5 were off by .4 times rounding_of this at most. Where
    /// it was done with twice the digits, (l / a)^2 eps takes the place of l / a.
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

/// The spheres of simplices that are asked for one after the other: several are looked at at once.
/// Not for several threads.
class Circumspheres {
public:
    /// Of the k-simplices of a complex, or those between points. Keep references.
    Circumspheres(const Pieces& complex, const SimplexMetric& metric, int k)
        : points_(metric.points()), simplices_(complex.simplices(k)) {
        if (!points_)
            layout_.emplace(complex, metric);
    }
    Circumspheres(const Points& points, const Simplices& simplices)
        : points_(&points), simplices_(simplices) {}

    /// That of simplex s, until the next call; its volume is 0 where there is none.
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

/// Circumradii of all k-simplices in the given table (rows of vertex numbers). These throw
/// InvalidInput, naming the vertices, for a simplex without volume, and for a vertex without point.
Vector circumradii(const Points& points, const Simplices& simplices);

/// Circumradii of all k-simplices of the complex.
Vector circumradii(const Pieces& complex, const SimplexMetric& metric, int k);

/// Circumcenters of all k-simplices in the given table: one row of N coordinates each. Throws
/// likewise.
Points circumcenters(const Points& points, const Simplices& simplices);

} // namespace polydec
