// SPDX-License-Identifier: MIT
#pragma once

#include "base/shared.h"
#include "base/types.h"

#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace polydec {

class Pieces;

/// The metric of a simplicial complex: points of its vertices, or only lengths of its edges, which
/// need not come from any points. All simplices are flat. Quantities measured per simplex (volumes,
/// duals, stars, merging, lift) can be computed from either. A handle: copies share the data.
class SimplexMetric {
public:
    /// Simplices between points, one row per vertex of the complex. Implicit, so points can be
    /// passed wherever a metric is expected.
    SimplexMetric(Points points) : points_(std::make_shared<const Points>(std::move(points))) {}
    SimplexMetric(std::shared_ptr<const Points> points, double error = 0)
        : points_(std::move(points)), error_(error) {}

    /// Simplices with only edge lengths known: size(1) numbers. circumcentric_volumes checks
    /// whether each simplex exists. Throws InvalidInput for a wrong number of lengths and, naming
    /// the edge, for a length that is not finite and positive, or whose square overflows or
    /// underflows (below 1e-100, above 1e100).
    SimplexMetric(const Pieces& complex, Vector lengths);

    /// Null if only lengths are known. Valid as long as a copy of this metric.
    const Points* points() const { return points_.get(); }

    /// Null if points are known. Valid likewise.
    const Vector* lengths() const { return lengths_.get(); }

    /// Bound on how far computed points are from those meant, as after a rotation; length. It
    /// counts as rounding of what is measured between them.
    double error() const { return error_; }

    /// Number N of coordinates of the points; 0 if only lengths are known.
    Index ambient_dimension() const {
        return points_ == nullptr ? 0 : static_cast<Index>(points_->cols());
    }

private:
    Shared<const Points> points_;
    Shared<const Vector> lengths_;
    double error_ = 0;
};

/// Lengths of the 1-simplices between points. Size size(1). Throws like require_points.
Vector edge_lengths(const Pieces& complex, const Points& points);

/// Points of the vertices of a complex, from a table with one row per vertex number. Throws
/// InvalidInput if the table has too few rows.
Points vertex_points(const Pieces& complex, const Points& by_number);

/// The other rows of such a table: the points that no simplex uses, in order.
Points isolated_points(const Pieces& complex, const Points& by_number);

/// Throws InvalidInput if `coordinates` is 0, as on a mesh where only lengths are known; `what`
/// names the function that needs points.
void require_points(Eigen::Index coordinates, std::string_view what);

/// The same; also throws unless there is one point per vertex of the complex.
void require_points(const Pieces& complex, const Points& points, std::string_view what);

/// The same; also throws if the pieces are not straight simplices between points (flipped edges).
void require_straight(const Pieces& complex, const Points& points, std::string_view what);

/// Circumradii of all k-simplices of the complex. Throws InvalidInput, naming the vertices, for a
/// simplex without volume.
Vector circumradii(const Pieces& complex, const SimplexMetric& metric, int k);

} // namespace polydec
