// SPDX-License-Identifier: MIT
#pragma once

#include "complex/pieces.h"
#include "dec/metric/circumsphere.h"

namespace polydec {

/// Where the dual has its vertices: one point for each simplex, by barycentric coordinates. The
/// dual of a k-simplex s is made of the simplices that the centers of s and of cofaces upon cofaces
/// of it span. Volumes, parts and pictures of duals follow from these coordinates: by definition
/// |s||*s| is C(n,k) times the volume of what s and its dual span together.
class Centers {
public:
    /// Circumcenters: duals are orthogonal to their simplices, and linear functions come out exact.
    /// Not positive where simplices are obtuse, and without extent where they are cospherical.
    Centers() = default;

    /// Centroids: every dual is positive on every mesh. They are not orthogonal to their simplices,
    /// so diagonal stars are consistent on regular simplices only.
    static Centers centroids();

    /// Of one's own: coordinates[k] has a row of k+1 coordinates for each k-simplex, in the order
    /// of its corners. Throws InvalidInput, naming the simplex, for a row that does not add up to
    /// 1, of another length, or with a number that is not finite.
    explicit Centers(std::vector<Points> coordinates);

    /// Circumcenters, but of each n-simplex a point of one's own, which several may share. Row t of
    /// `moments` tells of it, for each corner, n times the signed volume of what it spans with the
    /// facet without that corner: the height over the facet times the facet's volume. They add up
    /// to n times the volume; and they are numbers, as coordinates are not, where a simplex is flat
    /// and the point far from it. A row of `terms` goes with each simplex (see Circumsphere):
    /// growth and shift of what is uncertain, and of rounding. Throws InvalidInput for another
    /// number of rows or columns of these, and for numbers that are not finite.
    static Centers of_cells(Points moments, Points terms);

    bool are_circumcenters() const { return kind_ == Kind::circumcenters; }

    /// Throws InvalidInput unless there is a center for each simplex of the complex.
    void check_fit(const Pieces& complex) const;

    /// Whether a sphere needs not look at k-simplices, which may be flat then.
    bool know(int k) const { return kind_ == Kind::of_cells && k == given_->front().cols() - 1; }

    /// Signed distance from the facet without corner i to the center of k-simplex s, positive
    /// towards that corner, times the volume of the facet. The sphere has looked at s.
    double moment(int k, Index s, int i, const Circumsphere& sphere) const {
        return know(k) ? given_->front()(s, i)
                       : coordinate(k, s, i, sphere) * (k * sphere.volume());
    }

    /// The moments of all corners: these numbers, each times the factor.
    struct Moments {
        const double* numbers;
        double factor;
    };
    Moments moments(int k, Index s, const Circumsphere& sphere) const {
        if (know(k))
            return {&given_->front()(s, 0), 1};
        const double factor = k * sphere.volume();
        return kind_ == Kind::circumcenters || kind_ == Kind::of_cells
                   ? Moments{sphere.barycentric(), factor}
                   : Moments{&(*given_)[k](kind_ == Kind::centroids ? 0 : s, 0), factor};
    }

    double height(int k, Index s, int i, const Circumsphere& sphere, double facet_volume) const {
        return moment(k, s, i, sphere) / facet_volume;
    }

    /// Coordinate of the center of k-simplex s at corner i, the sphere having looked at s. Of an
    /// n-simplex without volume that shares its center those of the centroid: none weighs it.
    double coordinate(int k, Index s, int i, const Circumsphere& sphere) const {
        return know(k)                    ? shared_coordinate(s, i)
               : kind_ == Kind::centroids ? (*given_)[k](0, i)
               : kind_ == Kind::given     ? (*given_)[k](s, i)
                                          : sphere.barycentric(i);
    }

    /// To what errors of heights in k-simplex s are in proportion, the sphere having looked at it:
    /// given centers do not move when corners do.
    HeightTerms uncertainty(int k, Index s, const Circumsphere& sphere) const {
        return terms(k, s, sphere.uncertainty(), 0);
    }
    HeightTerms rounding(int k, Index s, const Circumsphere& sphere) const {
        return terms(k, s, sphere.rounding(), 2);
    }

private:
    enum class Kind { circumcenters, centroids, given, of_cells };

    HeightTerms terms(int k, Index s, const HeightTerms& of_sphere, int column) const {
        if (know(k))
            return {given_->back()(s, column), given_->back()(s, column + 1)};
        const bool moves = are_circumcenters() || kind_ == Kind::of_cells;
        return moves ? of_sphere : HeightTerms{of_sphere.growth, 0};
    }
    double shared_coordinate(Index s, int i) const;

    Kind kind_ = Kind::circumcenters;
    // by degree, a row for all centroids; of cells: moments, terms
    std::shared_ptr<const std::vector<Points>> given_;
};

/// The barycentric coordinates of the centers of all k-simplices: size(k) x (k+1).
Points center_coordinates(const Pieces& complex, const SimplexMetric& metric,
                          const Centers& centers, int k);

/// Rows of vertices, such as their points, at a place in each k-simplex with these coordinates.
/// Throws InvalidInput for tables of other numbers of rows or columns, and if there is no degree k.
Points combinations(const Pieces& complex, int k, const Points& coordinates,
                    const Points& of_vertices);

} // namespace polydec
