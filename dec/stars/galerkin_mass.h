// SPDX-License-Identifier: MIT
#pragma once

#include "dec/merging/merged_cells.h"

namespace polydec {

/// Inner products of Whitney forms on the cells, by the lift to their pieces; cells with flat
/// pieces are coned instead, from the mean of their vertices. Source: Whitney 1957.
class GalerkinMass {
public:
    /// Throws InvalidInput, naming the cell, unless cells with flat pieces are visible from that
    /// mean.
    explicit GalerkinMass(const MergedCells& cells);

    /// Inner products of k-forms, with the contribution of each n-cell times its weight, at least
    /// 0: size(k) x size(k), units length^(n-2k).
    SparseMatrix operator()(int k, const Vector& weights) const;

    /// Maps a symmetric matrix on the k-simplices of the pieces to the forms on cells.
    SparseMatrix lifted(int k, const SparseMatrix& of_pieces) const;

    const Pieces& pieces() const { return cells_.merging().pieces(); }
    const SimplexMetric& metric() const { return cells_.geometry().metric(); }

    /// The n-cell that contains a piece.
    Index cell(Index piece) const {
        return cells_.merging().carriers(pieces().dimension())[piece].cell;
    }

private:
    MergedCells cells_; // of pieces without flat ones
};

} // namespace polydec
