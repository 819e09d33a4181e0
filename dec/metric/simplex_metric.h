// SPDX-License-Identifier: MIT
#pragma once

#include "dec/metric/simplex_geometry.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace polydec {

/// The metric of a simplicial complex: points of its vertices, or lengths of its edges alone, which
/// need not come from any points. All simplices are flat. Whatever is measured simplex by simplex
/// (volumes, duals, stars, merging, lift) can be had from either. A handle: copies share what it
/// holds.
class SimplexMetric {
public:
    /// Simplices between points, a row per vertex of the complex; implicit, so that points can be
    /// passed wherever a metric is expected.
    SimplexMetric(Points points) : points_(std::make_shared<const Points>(std::move(points))) {}
    SimplexMetric(std::shared_ptr<const Points> points) : points_(std::move(points)) {}

    /// Simplices of which only the lengths of the edges are known: size(1) numbers. Whether each
    /// simplex exists is checked by circumcentric_volumes.
    /// Throws InvalidInput for another number of lengths and, naming the edge, for one that is not
    /// a finite number above 0, or of a size whose square is none (below 1e-100, above 1e100).
    SimplexMetric(const Pieces& complex, Vector lengths);

    /// Null where only lengths are known. Valid as long as a copy of this is.
    const Points* points() const { return points_.get(); }

    /// Null where points are known. Valid likewise.
    const Vector* lengths() const { return lengths_.get(); }

    /// Number N of coordinates of the points; 0 where only lengths are known.
    Index ambient_dimension() const {
        return points_ == nullptr ? 0 : static_cast<Index>(points_->cols());
    }

private:
    std::shared_ptr<const Points> points_;
    std::shared_ptr<const Vector> lengths_;
};

/// Where the corners of one simplex are: rows of a table of coordinates.
struct Corners {
    const Points& points;
    std::span<const Index> vertices; ///< the rows, in ascending order of the simplex's vertices
    bool by_lengths = false;         ///< not points that were given: distances are what is known
};

/// Places the corners of one simplex of a complex after the other. Not for several threads at once.
class SimplexLayout {
public:
    /// Keeps a reference to the complex: it must outlive the layout.
    SimplexLayout(const Pieces& complex, const SimplexMetric& metric);

    /// The corners of k-simplex s, until the next call. With points, these, as they are. With
    /// lengths a table of its own, k coordinates for each corner: the Cholesky factor of the
    /// products of the edges from one corner, which follow from the lengths. A simplex that does
    /// not exist is laid out without volume, and so is one of more than three corners with a height
    /// below 6e-8 of its edges (the rounding of squared lengths).
    Corners at(int k, Index s) {
        if (metric_.points() != nullptr)
            return {*metric_.points(), vertices(complex_.simplices(k), s)};
        return lay_out(k, s);
    }

    const Pieces& complex() const { return complex_; }

private:
    Corners lay_out(int k, Index s);
    void measure_edges(int k, Index s);
    int base(int k) const;
    template <class Corner>
    double height(int origin, Corner corner, int a, const double* known) const;
    double length(int i, int j) const { return lengths_[i * rows_.size() + j]; }
    double product(int origin, int i, int j) const;

    const Pieces& complex_;
    SimplexMetric metric_;
    std::vector<Index> rows_;     // 0..n
    std::vector<double> lengths_; // between corners i and j of one simplex, (n+1) x (n+1)
    std::vector<Points> tables_;  // by degree
};

/// Lengths of the 1-simplices between points. Size size(1). Throws like require_points.
Vector edge_lengths(const Pieces& complex, const Points& points);

/// Says why k-simplex s, whose faces all exist, cannot have the lengths that it is given.
std::string flaw_of_lengths(const Pieces& complex, const SimplexMetric& metric, int k, Index s);

/// The points of the vertices of a complex, of a table with a row per vertex number. Throws
/// InvalidInput if there are fewer.
Points vertex_points(const Pieces& complex, const Points& by_number);

/// The other rows of such a table: the points that no simplex uses, in order.
Points isolated_points(const Pieces& complex, const Points& by_number);

/// Throws InvalidInput if points have no coordinates, as those of a mesh of which only lengths are
/// known; what says who needs them.
void require_points(Eigen::Index coordinates, std::string_view what);

/// The same, and unless there is a point for each vertex of the complex.
void require_points(const Pieces& complex, const Points& points, std::string_view what);

/// The same, and if the pieces are not straight simplices between points, since edges were flipped.
void require_straight(const Pieces& complex, const Points& points, std::string_view what);

} // namespace polydec
