// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/cell_numbers.h"

namespace polydec {

/// Rows of numbers of all pieces of each own k-cell, wherever these are, in ascending order of
/// pieces: those of cell i stand from begins[i] on.
struct PieceRows {
    std::vector<Index> begins;
    Points rows;

    /// The rows of every cell added up, in their order, as one process would.
    Points sums() const;
};

/// Collective: `of_simplices` has a row for every local k-simplex; those that are no pieces, or
/// another rank's, do not matter.
PieceRows gather_pieces(const Ranks& ranks, const LocalComplex& local,
                        const DistributedCells::Degree& cells, int k, const Points& of_simplices);

/// Collective: the row of its cell for every local k-simplex that is a piece, 0 for the others;
/// `of_cells` has one for every own k-cell.
Points spread_to_pieces(const Ranks& ranks, const DistributedCells::Degree& cells,
                        const Points& of_cells);

} // namespace polydec
