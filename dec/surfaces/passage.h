// SPDX-License-Identifier: MIT
#pragma once

#include "complex/simplicial_complex.h"
#include "complex/surfaces/ordered_surface.h"
#include "dec/surfaces/intrinsic_delaunay.h"

#include <memory>
#include <string_view>

namespace polydec {

/// The way from the simplices of a mesh to the pieces that are measured and merged, and back. They
/// are the same unless the edges of a surface were flipped; nothing else knows of flips.
class Passage {
public:
    /// Where nothing was flipped: the pieces are the simplices.
    explicit Passage(SimplicialComplex input);

    /// From a surface to its triangles after flips and splits, which were made of
    /// GluedSurface(input). Vertices that splits have made are numbered from first_new_vertex on.
    Passage(SimplicialComplex input, IntrinsicDelaunay flips, Index first_new_vertex);

    const SimplicialComplex& input() const& { return input_; }
    SimplicialComplex input() && { return input_; }
    const Pieces& pieces() const& { return pieces_; }
    Pieces pieces() && { return pieces_; }

    /// Whether the pieces are the simplices.
    bool is_identity() const { return flipped_ == nullptr; }

    /// What was flipped. Throws InvalidInput where nothing was; what says who asks.
    const IntrinsicDelaunay& flips(std::string_view what = "what edges were flipped") const&;

    /// A primal k-cochain of the simplices as one of the pieces, a column each for several.
    /// Commutes with d. These throw InvalidInput, naming both sizes, for another number of values.
    DenseMatrix forth(int k, const DenseMatrix& values) const;

    /// The other way. Commutes with d; back after forth is the identity on vertices and on
    /// derivatives of functions.
    DenseMatrix back(int k, const DenseMatrix& values) const;

    /// The matrices of both; their rows grow where many flips follow each other.
    SparseMatrix matrix(int k) const;
    SparseMatrix matrix_back(int k) const;

private:
    struct Flipped {
        IntrinsicDelaunay flips;
        Vector directions;
    };
    Passage(SimplicialComplex input, OrderedSurface ordered, IntrinsicDelaunay&& flips);

    /// Values on k-pieces, as flips count these, or the other way round.
    Vector turned(int k, Vector values) const;

    SimplicialComplex input_;
    Pieces pieces_;
    std::shared_ptr<const Flipped> flipped_; // null: the identity
};

} // namespace polydec
