// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/merging/coned_cells.h"

#include <optional>

namespace polydec {

/// Inner products of Whitney forms on the cells, by the lift to their pieces; cells that have flat
/// ones are coned instead (see cone_flat_cells). Source: Whitney 1957.
class GalerkinMass {
public:
    /// Throws like cone_flat_cells.
    explicit GalerkinMass(const Discretization& mesh);

    /// Those of k-forms, each n-cell's times its weight, at least 0: size(k) x size(k), units
    /// length^(n-2k).
    SparseMatrix operator()(int k, const Vector& weights) const;

    /// What a symmetric matrix of the k-simplices of the pieces is for the forms on cells.
    SparseMatrix lifted(int k, const SparseMatrix& of_pieces) const;

    const Pieces& pieces() const { return merging().pieces(); }
    SimplexMetric metric() const { return coned_ ? SimplexMetric(coned_->points) : mesh_.metric(); }

    /// The n-cell that a piece belongs to.
    Index cell(Index piece) const { return merging().carriers(pieces().dimension())[piece].cell; }

private:
    const Merging& merging() const { return coned_ ? coned_->merging : mesh_.merging(); }

    Discretization mesh_;
    std::optional<ConedCells> coned_;
    std::vector<SparseMatrix> lift_; // of coned cells
};

} // namespace polydec
