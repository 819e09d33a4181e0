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

    bool are_circumcenters() const { return kind_ == Kind::circumcenters; }

    /// Throws InvalidInput unless there is a center for each simplex of the complex.
    void check_fit(const Pieces& complex) const;

    /// Coordinate of the center of k-simplex s at corner i, the sphere having looked at s.
    double coordinate(int k, Index s, int i, const Circumsphere& sphere) const {
        return kind_ == Kind::circumcenters ? sphere.barycentric(i)
               : kind_ == Kind::centroids   ? 1.0 / (k + 1)
                                            : (*given_)[k](s, i);
    }

    /// Signed distance from the facet without corner i to the center of k-simplex s, positive
    /// towards that corner.
    double height(int k, Index s, int i, const Circumsphere& sphere, double facet_volume) const {
        return coordinate(k, s, i, sphere) * k * sphere.volume() / facet_volume;
    }

    /// To what errors of heights are in proportion, of those that a sphere tells: given centers do
    /// not move when corners do.
    HeightTerms terms(const HeightTerms& of_sphere) const {
        return are_circumcenters() ? of_sphere : HeightTerms{of_sphere.growth, 0};
    }

private:
    enum class Kind { circumcenters, centroids, given };

    Kind kind_ = Kind::circumcenters;
    std::shared_ptr<const std::vector<Points>> given_; // by degree
};

/// The barycentric coordinates of the centers of all k-simplices: size(k) x (k+1).
Points center_coordinates(const Pieces& complex, const SimplexMetric& metric,
                          const Centers& centers, int k);

/// Rows of vertices, such as their points, at a place in each k-simplex with these coordinates.
/// Throws InvalidInput for tables of other numbers of rows or columns, and if there is no degree k.
Points combinations(const Pieces& complex, int k, const Points& coordinates,
                    const Points& of_vertices);

} // namespace polydec
