// SPDX-License-Identifier: MIT
#pragma once

#include "complex/simplicial_complex.h"

#include <memory>
#include <string_view>

namespace polydec {

struct IntrinsicDelaunay;

/// The passage from the simplices of a mesh to the pieces that are measured and merged, and back.
/// Both are the same unless the edges of a surface were flipped; no other class knows of flips.
class Passage {
public:
    /// The identity: the pieces are the simplices.
    explicit Passage(SimplicialComplex input);

    /// From a surface to its triangles after flips and splits of GluedSurface(input). Vertices
    /// added by splits are numbered from first_new_vertex on.
    Passage(SimplicialComplex input, IntrinsicDelaunay flips, Index first_new_vertex);

    const SimplicialComplex& input() const& { return input_; }
    SimplicialComplex input() && { return input_; }
    const Pieces& pieces() const& { return pieces_; }
    Pieces pieces() && { return pieces_; }

    /// Whether the pieces are the simplices.
    bool is_identity() const { return flipped_ == nullptr; }

    /// The flips. Throws InvalidInput if nothing was flipped; `what` names the caller.
    const IntrinsicDelaunay& flips(std::string_view what = "what edges were flipped") const&;

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
    std::shared_ptr<const Flipped> flipped_; // null: the identity
};

} // namespace polydec
