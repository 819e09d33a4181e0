// SPDX-License-Identifier: MIT
#pragma once

#include "complex/cell_complex.h"

namespace polydec {

/// Writes a coboundary d_k row by row, from the sides of cells in any order.
class IncidenceRows {
public:
    /// For given numbers of (k+1)-cells, k-cells and sides.
    IncidenceRows(Index cells, Index faces, Index sides);

    /// Adds a side of the next cell.
    void add(Index face, int sign) {
        ++counts_[face];
        sides_.push_back({face, sign});
    }

    /// Ends the next cell. Signs of equal faces add up; faces whose signs cancel are recorded,
    /// since the cell has them on both sides.
    void end_cell();

    /// Returns the result, after the last cell.
    void finish(IncidenceMatrix& coboundary, CofaceCounts& coface_counts,
                std::vector<Incidence>& canceled);

private:
    IncidenceMatrix rows_;
    std::vector<Index> counts_;
    std::vector<Incidence> canceled_;
    std::vector<SignedFace> sides_; // of the cell being written
    Index cell_ = 0, end_ = 0;      // its number, and the number of entries
};

} // namespace polydec
