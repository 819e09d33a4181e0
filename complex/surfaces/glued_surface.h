// SPDX-License-Identifier: MIT
#pragma once

#include "complex/pieces.h"

#include <array>
#include <cstdint>
#include <vector>

namespace polydec {

/// Triangles, any number of them at an edge: the connectivity for heat on surfaces, also branching
/// ones.
///
/// Half-edge 3 t + i runs along triangle t from its corner i to the next corner. Every edge has a
/// direction; the sign of a half-edge is 1 along its edge and -1 against it. Accessors serve
/// innermost loops and do not check numbers.
class Triangles {
public:
    /// One side of a triangle: its edge, and the sign of the half-edge.
    struct SignedEdge {
        Index edge;
        std::int8_t sign;
    };

    /// A half-edge: a side, and the vertex where it starts.
    struct Halfedge : SignedEdge {
        Index tail;
    };

    static constexpr int dimension = 2;

    /// The triangles of pieces; vertices, edges and triangles keep their numbers and orientations.
    /// Linear time. Throws InvalidInput if the dimension is not 2.
    explicit Triangles(const Pieces& surface);

    Index vertices() const { return vertices_; }
    Index edges() const { return edges_; }
    Index triangles() const { return static_cast<Index>(sides_.size() / 3); }

    /// The number by which messages name a vertex: that of the pieces; its own without pieces.
    Index vertex_number(Index v) const { return names_.empty() ? v : names_[v]; }

    static Index triangle(Index halfedge) { return halfedge / 3; }
    static Index next(Index halfedge) { return halfedge % 3 == 2 ? halfedge - 2 : halfedge + 1; }
    static Index previous(Index halfedge) {
        return halfedge % 3 == 0 ? halfedge + 2 : halfedge - 1;
    }

    const Halfedge& operator[](Index halfedge) const { return sides_[halfedge]; }
    Index tail(Index halfedge) const { return sides_[halfedge].tail; }
    Index head(Index halfedge) const { return sides_[next(halfedge)].tail; }
    Index edge(Index halfedge) const { return sides_[halfedge].edge; }
    int sign(Index halfedge) const { return sides_[halfedge].sign; }

protected:
    Triangles() = default;

    std::vector<Halfedge> sides_;
    std::vector<Index> names_; // of vertices, or empty
    Index vertices_ = 0, edges_ = 0;
};

/// A surface of triangles glued along their edges, at most two at each edge: a Delta-complex.
/// Unlike in a simplicial complex, edges may be loops, several edges may join the same vertices, a
/// triangle may be glued to itself, and the surface may be one-sided. It knows no lengths.
class GluedSurface : public Triangles {
public:
    /// Whether the triangles of these pieces can be glued: at most two meet at each edge.
    static bool accepts(const Pieces& surface);

    /// The triangles of pieces, e.g. of a simplicial surface. Vertices, edges and triangles keep
    /// their numbers and orientations. Linear time. Throws InvalidInput, naming the edge, if three
    /// triangles meet there, or if the dimension is not 2.
    explicit GluedSurface(const Pieces& surface);

    /// Triangles glued along sides with the same edge number: three sides per triangle, edges
    /// numbered from 0 without gaps. Corners that the gluing identifies are one vertex; vertices
    /// are numbered in the order of their first corners. Throws InvalidInput, naming the edge, if
    /// it has no side or more than two, and for signs other than 1 and -1.
    explicit GluedSurface(const std::vector<std::array<SignedEdge, 3>>& triangles);

    /// The half-edges of an edge; the second is -1 on the boundary.
    const std::array<Index, 2>& halfedges(Index edge) const { return halfedges_[edge]; }
    bool is_boundary(Index edge) const { return halfedges_[edge][1] < 0; }

    /// The other half-edge of the same edge; -1 on the boundary.
    Index partner(Index halfedge) const {
        const auto& both = halfedges_[edge(halfedge)];
        return both[0] == halfedge ? both[1] : both[0];
    }

    /// The start and end vertices of an edge.
    Index first_vertex(Index edge) const {
        const Index h = halfedges_[edge][0];
        return sign(h) > 0 ? tail(h) : head(h);
    }
    Index last_vertex(Index edge) const {
        const Index h = halfedges_[edge][0];
        return sign(h) > 0 ? head(h) : tail(h);
    }

    /// Whether two different triangles meet at an edge, so that it can be flipped.
    bool can_flip(Index edge) const {
        const auto& [h, g] = halfedges_[edge];
        return g >= 0 && triangle(h) != triangle(g);
    }

    /// Reverses the orientation of a triangle.
    void reverse(Index triangle);

    /// Replaces an edge by the other diagonal of its two triangles, which must be oriented alike
    /// there. With half-edges i -> j in the first triangle t = ijk and j -> i in u = jil, t becomes
    /// klj and u becomes lki; each begins with the flipped edge. An edge with direction i -> j gets
    /// direction k -> l.
    void flip(Index edge);

    /// Splits a boundary edge at a new vertex m, and with it its triangle t = ijk (i -> j the
    /// boundary half-edge). t becomes imk and its edges keep their numbers; the new triangle is
    /// mjk. The new edges are m -> j, in the direction of the old edge, and then m -> k.
    void split_boundary(Index edge);

    /// Whether the triangles on both sides of an edge are oriented alike; true on the boundary.
    bool is_coherent(Index edge) const {
        const auto& [h, g] = halfedges_[edge];
        return g < 0 || sign(h) != sign(g);
    }

private:
    /// Where the edge of a half-edge lists it.
    Index& listed(Index halfedge) {
        auto& both = halfedges_[edge(halfedge)];
        return both[0] == halfedge ? both[0] : both[1];
    }

    std::vector<std::array<Index, 2>> halfedges_; // of edges
};

} // namespace polydec
