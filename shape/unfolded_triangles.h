// SPDX-License-Identifier: MIT
#pragma once

#include "base/groups.h"
#include "complex/surfaces/glued_surface.h"

#include <span>
#include <vector>

namespace polydec {

/// A surface for tracing straight lines from triangle to triangle: each triangle lies in its own
/// plane, given by lengths alone.
class UnfoldedTriangles {
public:
    /// A side of a triangle, with the angle at its tail.
    struct Side {
        double length, cosine, sine;
        Index tail, edge;
        int sign;
    };

    /// Throws InvalidInput, naming edge or triangle, unless the lengths form triangles with area.
    UnfoldedTriangles(const Triangles& surface, const Vector& lengths);

    Index vertices() const { return static_cast<Index>(may_bend_.size()); }
    Index triangles() const { return static_cast<Index>(sides_.size() / 3); }
    Index edges() const { return edges_; }

    /// Input lengths are the lengths here times 2^exponent. The longest edge is near 2^400, so that
    /// squares of lengths do not underflow down to 1e-270 of it.
    int exponent() const { return exponent_; }

    const Side& side(Index halfedge) const { return sides_[halfedge]; }

    /// The half-edges of an edge, one per triangle at it.
    std::span<const Index> sides_of(Index edge) const { return sides_of_[edge]; }

    /// The corners at a vertex, each given by its outgoing half-edge.
    std::span<const Index> corners_of(Index vertex) const { return corners_of_[vertex]; }

    /// Whether a shortest path may bend at a vertex: true unless the triangles around it form one
    /// closed fan with total angle at most 2 pi, or one open fan with at most pi.
    bool may_bend(Index vertex) const { return may_bend_[vertex]; }

private:
    void find_bends(const Triangles& surface);

    int exponent_ = 0;
    std::vector<Side> sides_;
    Groups sides_of_, corners_of_;
    std::vector<bool> may_bend_;
    Index edges_ = 0;
};

} // namespace polydec
