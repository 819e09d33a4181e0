// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/cell_numbers.h"
#include "io/checkpoint.h"

namespace polydec {

/// What a checkpoint has of the cells that ranks own: a vector for each of these degrees, with the
/// values of own cells.
struct SharedCheckpoint {
    Checkpoint own = {};           ///< state[i] has those of degrees[i]
    std::vector<int> degrees = {}; ///< of cells
};

/// Collective: writes it, whole or not at all, by the numbers of cells: the same bytes on any
/// number of ranks, and those of write_checkpoint in one process. They go through rank 0, a stretch
/// of cells at a time. Throws InvalidInput for vectors that do not fit, IoError if writing fails.
void write_checkpoint(const Ranks& ranks, const std::filesystem::path& path,
                      const DistributedCells& cells, const SharedCheckpoint& checkpoint);

/// Collective: reads it, to the same bits, whoever wrote it. Throws as in one process, and for
/// another number of cells than these degrees have.
SharedCheckpoint read_checkpoint(const Ranks& ranks, const std::filesystem::path& path,
                                 const DistributedCells& cells, std::uint64_t problem,
                                 const std::vector<int>& degrees);

} // namespace polydec
