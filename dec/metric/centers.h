// SPDX-License-Identifier: MIT
#pragma once

#include "base/shared.h"
#include "base/types.h"

#include <vector>

namespace polydec {

class Pieces;
class SimplexMetric;

/// The vertices of the dual: one point per simplex, in barycentric coordinates. The dual of a
/// k-simplex s consists of the simplices that the centers of s and of ascending chains of cofaces
/// span. Volumes, parts and pictures of duals follow from the coordinates: by definition |s||*s| is
/// C(n,k) times the volume that s and its dual span together.
class Centers {
public:
    /// Circumcenters: duals are orthogonal to their simplices, and linear functions are exact. Dual
    /// volumes are not positive where simplices are obtuse, and zero where they are cospherical.
    Centers() = default;

    /// Centroids: every dual is positive on every mesh. Duals are not orthogonal to their
    /// simplices, so diagonal stars are consistent on regular simplices only.
    static Centers centroids();

    /// Custom centers: coordinates[k] has one row of k+1 coordinates per k-simplex, in the order of
    /// its corners. Throws InvalidInput, naming the simplex, for a row that does not sum to 1, has
    /// the wrong length, or contains a number that is not finite.
    explicit Centers(std::vector<Points> coordinates);

    /// Circumcenters, except that each n-simplex has a custom point, which several may share. Row t
    /// of `moments` has for each corner n times the signed volume that the point spans with the
    /// facet without that corner: the height over the facet times the facet's volume. A row sums to
    /// n times the volume. Moments, unlike coordinates, are finite if a simplex is flat and the
    /// point far away. Row t of `terms` (see Circumsphere): growth and shift of the uncertainty,
    /// then of rounding. Throws InvalidInput for a wrong number of rows or columns, and for numbers
    /// that are not finite.
    static Centers of_cells(Points moments, Points terms);

    bool are_circumcenters() const { return kind_ == Kind::circumcenters; }

    /// Throws InvalidInput unless there is one center per simplex of the complex.
    void check_fit(const Pieces& complex) const;

private:
    friend class CenterHeights;
    enum class Kind { circumcenters, centroids, given, of_cells };

    Kind kind_ = Kind::circumcenters;
    // one vector entry per degree; a single row for all centroids; for of_cells: moments, terms
    Shared<const std::vector<Points>> given_;
};

/// The barycentric coordinates of the centers of all k-simplices: size(k) x (k+1).
Points center_coordinates(const Pieces& complex, const SimplexMetric& metric,
                          const Centers& centers, int k);

/// Combines rows of vertices, such as their points, at the place in each k-simplex with these
/// coordinates. Throws InvalidInput for tables of the wrong size, and if there is no degree k.
Points combinations(const Pieces& complex, int k, const Points& coordinates,
                    const Points& of_vertices);

} // namespace polydec
