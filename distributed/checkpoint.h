// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/cell_numbers.h"
#include "io/checkpoint.h"

namespace polydec {

/// The own part of a checkpoint: for each of these degrees, a vector with the values of own cells.
struct SharedCheckpoint {
    Checkpoint own = {};           ///< state[i] belongs to degrees[i]
    std::vector<int> degrees = {}; ///< of cells
};

/// Collective: writes it, whole or not at all, ordered by cell numbers: the same bytes on any
/// number of ranks, and as write_checkpoint in one process. Data pass through rank 0, a range of
/// cells at a time. Throws InvalidInput for vectors that do not fit, IoError if writing fails.
void write_checkpoint(const Ranks& ranks, const std::filesystem::path& path,
                      const DistributedCells& cells, const SharedCheckpoint& checkpoint);

/// Collective: reads it, to the same bits, from any writer. Throws as in one process, and for a
/// wrong number of cells of these degrees.
SharedCheckpoint read_checkpoint(const Ranks& ranks, const std::filesystem::path& path,
                                 const DistributedCells& cells, std::uint64_t problem,
                                 const std::vector<int>& degrees);

} // namespace polydec
