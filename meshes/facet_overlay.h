// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/divided_triangles.h"

#include <map>
#include <vector>

namespace polydec {

/// A vertex where two edges cross: at (1 - s) a + s b, and at (1 - t) c + t d.
struct Crossing {
    Index a, b, c, d; ///< a < b, c < d, a < c
    double s, t;
};

/// Overlapping triangles in space, divided so that both sides agree: into the common part of each
/// pair, and the rest of each triangle.
class FacetOverlay {
public:
    /// Takes triangles by ascending corners, with the non-corner vertices in each. Points at most
    /// `length` apart coincide.
    FacetOverlay(const Simplices& triangles, const std::vector<std::vector<Index>>& inside,
                 const Points& points, double length);

    /// New vertices, numbered after the points.
    const std::vector<Crossing>& crossings() const { return crossings_; }
    std::vector<DividedEdges::Entry> on_edges() const;
    const Points& points() const { return points_; } ///< of all vertices

    /// These points followed by the crossings; a crossing is the mean of its places on both edges.
    static Points with_crossings(const Points& points, const std::vector<Crossing>& crossings);

    /// Parts of the overlapping triangles; the edges are divided at all vertices, including new
    /// ones. If the rest of a triangle is not simply connected, its parts form a fan around a
    /// vertex in it and overlap again.
    std::vector<TrianglePart> parts(const DividedEdges& edges) const;

private:
    struct Common {
        Index f, g;                 // triangles
        std::vector<Index> corners; // around the common part, in the direction of f
    };

    Triangle corners(Index f) const {
        return {triangles_(f, 0), triangles_(f, 1), triangles_(f, 2)};
    }
    bool lies_in(Index v, Index f) const;
    void cross(Index f, Index g, std::vector<Index>& common);
    void cross(Index a, Index b, Index c, Index d, std::vector<Index>& common);
    void overlay(Index f, Index g);
    Eigen::RowVectorXd point(Index v) const;
    Eigen::MatrixX2d in_plane(Index f, const std::vector<Index>& vertices) const;
    bool is_turned(Index f, Index g) const;
    void add_vertices(const Common& common, const DividedEdges& edges,
                      std::vector<Index>& corners) const;
    std::vector<Index> outline(Index f, const DividedEdges& edges) const;
    void add_fan(Index f, const DividedEdges& edges, std::vector<TrianglePart>& parts) const;
    bool add_remainders(Index f, const std::vector<std::vector<Index>>& covered,
                        const DividedEdges& edges,
                        std::vector<std::vector<Index>>& remainders) const;

    Simplices triangles_;
    Points points_;
    double length_;
    std::vector<std::vector<Index>> vertices_; // in each triangle, ascending, with its corners
    std::vector<Crossing> crossings_;
    std::map<std::array<Index, 4>, Index> numbers_; // of crossings, by their edges
    std::vector<Common> commons_;
};

} // namespace polydec
