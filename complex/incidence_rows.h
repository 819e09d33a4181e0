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
        constexpr Index few = 32; // which insertion sorts best
        ++counts_[face];
        Index place = end_++;
        for (; place > begin_ && faces_[place - 1] > face && place < begin_ + few; --place) {
            faces_[place] = faces_[place - 1];
            signs_[place] = signs_[place - 1];
        }
        if (place > begin_ && faces_[place - 1] >= face)
            are_ascending_ = false;
        faces_[place] = face;
        signs_[place] = static_cast<std::int8_t>(sign);
    }

    /// Ends the next cell. Signs of equal faces add up; faces whose signs cancel are recorded,
    /// since the cell has them on both sides.
    void end_cell() {
        if (!are_ascending_)
            add_up();
        rows_.outerIndexPtr()[++cell_] = begin_ = end_;
    }

    /// Returns the result, after the last cell.
    Coboundary finish();

private:
    void add_up();

    IncidenceMatrix rows_;
    Index* faces_; // of the rows
    std::int8_t* signs_;
    std::vector<Index> counts_;
    std::vector<Incidence> canceled_;
    Index cell_ = 0, begin_ = 0, end_ = 0; // the cell being written, its first entry, the next
    bool are_ascending_ = true;            // its faces so far
};

} // namespace polydec
