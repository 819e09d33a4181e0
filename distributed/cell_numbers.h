// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/merging.h"

namespace polydec {

/// The number of a cell of the merged complex, common to all ranks.
struct CellNumber {
    GlobalIndex number = -1; ///< among all of its degree, by first pieces, as in one process
    GlobalIndex row = -1;    ///< in matrices and vectors, where each rank's rows are contiguous
};

/// The merged complex over all ranks: each rank owns the cells whose first pieces it owns.
struct DistributedCells {
    /// The cells of one degree.
    struct Degree {
        GlobalIndex count = 0;           ///< on all ranks
        GlobalIndex first_row = 0;       ///< of own cells
        std::vector<Index> first;        ///< own cells: their first pieces here, ascending
        std::vector<GlobalIndex> number; ///< of these cells
        std::vector<CellNumber> others;  ///< cells of other ranks with pieces here, by rows
        std::vector<Index> of_simplex;   ///< the cell of each piece here; -1 if it is removed
        /// Own k-cells with their cofaces, cells of degree k + 1, and their signs: rows of d_k^T.
        std::vector<Index> begins = {0};
        std::vector<Index> cofaces;
        std::vector<std::int8_t> signs;

        /// Number of own cells.
        Index own() const { return static_cast<Index>(first.size()); }

        /// The number of a cell known here: own cells first, then others.
        CellNumber cell(Index i) const {
            return i < own() ? CellNumber{number[i], first_row + i} : others[i - own()];
        }
    };
    std::vector<Degree> degrees;
    CellVolumes volumes; ///< of own cells, bit by bit as in one process

    int dimension() const { return static_cast<int>(degrees.size()) - 1; }
    const Degree& degree(int k) const { return degrees[k]; }
};

/// Collective: numbers, volumes and incidences of the merged cells.
DistributedCells distributed_cells(const Ranks& ranks, const LocalComplex& local,
                                   const DistributedMerging& merged);

} // namespace polydec
