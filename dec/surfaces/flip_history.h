// SPDX-License-Identifier: MIT
#pragma once

#include "complex/surfaces/glued_surface.h"

#include <array>
#include <vector>

namespace polydec {

/// The steps applied to a glued surface, so that cochains can follow: flips, splits of boundary
/// edges, reversed triangles. A flip is a merge followed by a lift: both triangles share the sum of
/// the old values, and the circulation around the quadrilateral, in proportion to area. This fixes
/// the value on the new edge.
class FlipHistory {
public:
    /// The empty history of a surface.
    explicit FlipHistory(const GluedSurface& surface);

    /// Record each step before the surface takes it. A share is the first triangle's fraction of
    /// the area of both, before or after the flip.
    void flip(const GluedSurface& surface, Index edge, double share_before, double share_after);
    /// `fraction`: position of the new vertex, from 0 at the tail of the boundary half-edge to 1.
    void split_boundary(const GluedSurface& surface, Index edge, double fraction);
    void reverse(Index triangle);

    /// For each vertex added by splits, its edge of the first surface: the two ends.
    std::vector<std::array<Index, 2>> edges_of_new_vertices() const;

    /// Maps a primal k-cochain of the first surface to the last. Commutes with d; vertices keep
    /// their values, and new vertices interpolate linearly along their edge. Time of the order of
    /// the steps. Throws InvalidInput, naming both sizes, unless there is one value per k-cell.
    Vector carry(int k, const Vector& values) const;

    /// Maps back from the last surface by the inverse steps. Commutes with d; carry_back after
    /// carry is the identity on vertices and on derivatives of functions.
    Vector carry_back(int k, const Vector& values) const;

    /// The matrix of carry: cells of the last surface times cells of the first. Its rows fill in
    /// where many flips follow each other.
    SparseMatrix matrix(int k) const;

    /// The matrix of carry_back: cells of the first surface times cells of the last.
    SparseMatrix matrix_back(int k) const;

private:
    enum class Kind : std::uint8_t { flip, split, reverse };

    struct Step {
        Kind kind;
        std::int8_t sign;                               // of the edge: i -> j, later k -> l
        Index edge, first, second;                      // triangles; a split makes the second
        std::array<GluedSurface::SignedEdge, 4> around; // jk, ki, il, lj; of a split jk, ki, mj, mk
        std::array<Index, 3> vertices;                  // of a split: i, j, m
        double before, after;                           // shares; of a split the fraction
    };

    template <class Values>
    void apply(const Step& step, int k, Values& values) const;
    template <class Values>
    void undo(const Step& step, int k, Values& values) const;

    std::array<Index, 3> first_sizes_, last_sizes_;
    std::vector<Step> steps_;
};

} // namespace polydec
