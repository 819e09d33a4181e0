// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"
#include "dec/discretization.h"
#include "dec/forms/boundary_conditions.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

namespace polydec {

/// 64 bits by which what belongs together is known again: the same numbers and words in the same
/// order give the same value on every machine. No protection against intent.
class Fingerprint {
public:
    Fingerprint& add(std::uint64_t word);
    Fingerprint& add(double number);
    Fingerprint& add(std::string_view text);
    Fingerprint& add(const Eigen::Ref<const DenseMatrix>& numbers);

    /// Every entry of a star.
    Fingerprint& add(const HodgeStar& star);

    /// Those of every facet, coefficients, and fixed vertices.
    Fingerprint& add(const BoundaryConditions& conditions);

    /// Points, simplices, merged cells, volumes and stars of a mesh.
    Fingerprint& add(const Discretization& mesh);

    std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 0xcbf29ce484222325;
};

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
