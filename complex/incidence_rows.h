// SPDX-License-Identifier: MIT
#pragma once

#include "complex/cell_complex.h"

namespace polydec {

/// Writes a coboundary d_k row by row, from the sides of cells in any order.
class IncidenceRows {
public:
    /// For so many (k+1)-cells and k-cells, and so many sides in all.
    IncidenceRows(Index cells, Index faces, Index sides);

    /// A side of the next cell.
    void add(Index face, int sign) {
        ++counts_[face];
        sides_.push_back({face, sign});
    }

    /// All sides of the next cell were added. Signs of equal faces add up; those that cancel are
    /// noted, being a face that the cell has on both sides.
    void end_cell();

    /// What was written, after the last cell.
    void finish(IncidenceMatrix& coboundary, CofaceCounts& coface_counts,
                std::vector<Incidence>& canceled);

private:
    IncidenceMatrix rows_;
    std::vector<Index> counts_;
    std::vector<Incidence> canceled_;
    std::vector<SignedFace> sides_; // of the cell that is being written
    Index cell_ = 0, end_ = 0;      // its number, and that of the entries
};

} // namespace polydec
