// SPDX-License-Identifier: MIT
#pragma once

#include "base/shared.h"
#include "complex/simplicial_complex.h"

#include <array>
#include <string_view>

namespace polydec {

struct IntrinsicDelaunay;

/// The passage from the simplices of a mesh to the pieces that are measured and merged, and back.
/// Both are the same unless edges of a surface were flipped; no other class knows of flips.
class Passage {
public:
    /// The identity: the pieces are the simplices.
    explicit Passage(SimplicialComplex input);

    /// From a surface to its triangles after flips and splits of GluedSurface(input). Vertices
    /// added by splits are numbered from first_new_vertex on. The identity where nothing was
    /// flipped or split, and no length added.
    Passage(SimplicialComplex input, IntrinsicDelaunay flips, Index first_new_vertex);

    const SimplicialComplex& input() const& { return input_; }
    SimplicialComplex input() && { return input_; }
    const Pieces& pieces() const& { return pieces_; }
    Pieces pieces() && { return pieces_; }

    /// Whether the pieces are the simplices.
    bool is_identity() const;

    /// What was flipped and split: nothing, if no edge needed it. Throws InvalidInput, naming the
    /// caller by `what`, for a passage that was made without flips.
    const IntrinsicDelaunay& flips(std::string_view what = "what edges were flipped") const&;
    IntrinsicDelaunay flips(std::string_view what = "what edges were flipped") &&;

    /// Maps primal k-cochains (columns) from the simplices to the pieces. Commutes with d. Both
    /// directions throw InvalidInput, naming both sizes, for a wrong number of values.
    DenseMatrix forth(int k, const DenseMatrix& values) const;

    /// Maps from the pieces to the simplices. Commutes with d; back after forth is the identity on
    /// vertices and on derivatives of functions.
    DenseMatrix back(int k, const DenseMatrix& values) const;

    /// The matrices of forth and back; rows fill in where many flips follow each other.
    SparseMatrix matrix(int k) const;
    SparseMatrix matrix_back(int k) const;

private:
    struct Flipped;

    /// Values on k-pieces in the orientation of the flips, or the other way round.
    Vector turned(int k, Vector values) const;

    SimplicialComplex input_;
    Pieces pieces_;
    Shared<const Flipped> flipped_; // null: none were asked for
};

/// The input's triangles cut along the edges of the flipped triangles: convex flat pieces, each in
/// one triangle of both. They show results of the flipped triangulation on the input.
struct Overlay {
    /// Crossing on an edge of the input: its ends, and the position from the first end, from 0 to
    /// 1.
    struct Crossing {
        Index from, to;
        double place;
    };

    Points points; ///< of the input, then of splits, then crossings of the edges of both
    std::vector<Crossing> crossings; ///< one for each of the last points
    std::vector<Index> corners;      ///< of all pieces, concatenated, each in cyclic order
    /// For each corner its barycentric coordinates in the triangle after flips.
    std::vector<std::array<double, 3>> coordinates;
    std::vector<Index> offsets;     ///< piece p has the corners from offsets[p] on
    std::vector<Index> input;       ///< for each piece: the triangle of the input
    std::vector<Index> triangle;    ///< for each piece: the triangle after flips
    std::vector<std::int8_t> signs; ///< 1 if both are oriented alike, else -1
    Vector areas;                   ///< of the pieces, length^2

    /// Interpolates rows at vertices linearly along the input's edges, for all points. Throws
    /// InvalidInput unless there is one row per vertex of the input and of splits.
    Points at_points(const Points& at_vertices) const;

    Index size() const { return static_cast<Index>(input.size()); }
};

/// Follows every edge of the input across the flipped triangles by the normal coordinates, and lays
/// the strips of triangles flat to locate the crossings. Drops pieces whose area is zero up to
/// rounding. Time of the order of all crossings, and log(triangles) for each. `points`: the points
/// of the input, then of the vertices added by splits, as in Discretization. Throws InvalidInput
/// for the identity.
Overlay overlay(const Passage& passage, const Points& points);

} // namespace polydec
