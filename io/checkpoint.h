// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

namespace polydec {

/// How far a computation in time got.
struct Checkpoint {
    std::uint64_t problem = 0; ///< of what it belongs to: mesh, equation, options
    std::uint64_t step = 0;
    double time = 0;
    std::vector<Vector> state = {}; ///< in the order of cells
};

/// Writes a checkpoint piece by piece, for who does not have all of it in one place.
class CheckpointWriter {
public:
    /// sizes are those of the vectors of the state. Throws IoError if nothing can be written there.
    CheckpointWriter(const std::filesystem::path& path, const Checkpoint& without_state,
                     const std::vector<std::int64_t>& sizes);
    ~CheckpointWriter();

    /// The next numbers of the state.
    void add(const Vector& values);

    /// Ends it, when all have come. Throws IoError if writing fails.
    void commit();

private:
    struct Words;
    std::unique_ptr<Words> words_;
};

/// Writes it, whole or not at all, 8 bytes a number. Throws IoError if writing fails.
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);

/// Reads it, to the same bits. Throws InvalidInput for a file that is none, is damaged, or belongs
/// to another problem; IoError if it cannot be read.
Checkpoint read_checkpoint(const std::filesystem::path& path, std::uint64_t problem);

} // namespace polydec
