// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

namespace polydec {

/// The saved state of a computation in time.
struct Checkpoint {
    std::uint64_t problem = 0; ///< fingerprint of mesh, equation and options
    std::uint64_t step = 0;
    double time = 0;
    std::vector<Vector> state = {}; ///< in the order of cells
};

/// Writes a checkpoint in parts.
class CheckpointWriter {
public:
    /// `sizes` are the lengths of the state vectors. Throws IoError if the path is not writable.
    CheckpointWriter(const std::filesystem::path& path, const Checkpoint& without_state,
                     const std::vector<std::int64_t>& sizes);
    ~CheckpointWriter();

    /// Appends the next numbers of the state.
    void add(const Vector& values);

    /// Finishes the file after all numbers are added. Throws IoError if writing fails.
    void commit();

private:
    struct Words;
    std::unique_ptr<Words> words_;
};

/// Writes a checkpoint, whole or not at all, 8 bytes a number. Throws IoError if writing fails.
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint);

/// Reads a checkpoint, to the same bits. Throws InvalidInput for a file that is not a checkpoint,
/// is damaged, or belongs to another problem; IoError if it cannot be read.
Checkpoint read_checkpoint(const std::filesystem::path& path, std::uint64_t problem);

} // namespace polydec
