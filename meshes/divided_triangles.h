// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <array>
#include <compare>
#include <utility>
#include <vector>

namespace polydec {

using Triangle = std::array<Index, 3>;

/// The corners in ascending order.
Triangle ascending(Triangle corners);

/// A triangle and one of its parts.
using TrianglePart = std::pair<Triangle, Triangle>;

/// Vertices in the interior of edges, ordered on each edge from its lesser end.
class DividedEdges {
public:
    struct Entry {
        Index a, b;   ///< a < b
        double place; ///< 0 at a, 1 at b
        Index vertex;

        auto operator<=>(const Entry&) const = default;
    };

    /// Entries in any order, possibly repeated.
    explicit DividedEdges(std::vector<Entry> entries);

    bool contains(Index a, Index b) const;

    /// Appends a, then the vertices on the edge from a to b.
    void append(Index a, Index b, std::vector<Index>& corners) const;

private:
    using Place = std::vector<Entry>::const_iterator;
    std::pair<Place, Place> of(Index a, Index b) const;

    std::vector<Entry> entries_;
};

/// Triangles that are divided: by a given tiling, or else by the vertices on their edges.
class DividedTriangles {
public:
    /// Tiled triangles have ascending corners.
    DividedTriangles(DividedEdges edges, std::vector<TrianglePart> tiles);

    bool is_divided(const Triangle& corners) const;

    /// Divides triangles that need it. Their parts are stored under the corners in this order.
    void divide(std::vector<Triangle> triangles, const Points& points);

    /// The triangle itself if it was not divided.
    std::vector<Triangle> parts(const Triangle& corners) const;

    const DividedEdges& edges() const { return edges_; }

private:
    using Place = std::vector<TrianglePart>::const_iterator;
    std::pair<Place, Place> of(const Triangle& corners) const;

    DividedEdges edges_;
    std::vector<TrianglePart> parts_;
};

} // namespace polydec
