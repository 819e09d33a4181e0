// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"
#include "io/partial_file.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace polydec {

/// The layout of .pdm, polydec's own mesh format for reading in parts: a header of 128 bytes; the
/// points as doubles; the vertices of cells from 0 in 4 bytes, or 8 if there are 2^31 or more; the
/// tags, if any, in 4; and a CRC-32 (4 bytes) of every MiB between header and checksums.
/// Little-endian. All places are in bytes.
struct PdmLayout {
    static constexpr std::int64_t header_bytes = 128, block_bytes = 1 << 20, sum_bytes = 4;

    std::int64_t ambient_dimension = 0, dimension = 0, vertices = 0, cells = 0;
    bool has_tags = false;

    std::int64_t number_bytes() const { return vertices > INT32_MAX ? 8 : 4; }
    std::int64_t point_bytes() const { return 8 * ambient_dimension; }
    std::int64_t cell_bytes() const { return number_bytes() * (dimension + 1); }
    std::int64_t cells_begin() const { return header_bytes + vertices * point_bytes(); }
    std::int64_t tags_begin() const { return cells_begin() + cells * cell_bytes(); }
    std::int64_t sums_begin() const { return tags_begin() + (has_tags ? 4 * cells : 0); }
    std::int64_t blocks() const {
        return (sums_begin() - header_bytes + block_bytes - 1) / block_bytes;
    }
    std::int64_t file_bytes() const { return sums_begin() + sum_bytes * blocks(); }

    /// The begin of a block; the next one is its end.
    std::int64_t block_begin(std::int64_t block) const {
        return std::min(sums_begin(), header_bytes + block * block_bytes);
    }
};

/// The header bytes of a file with this layout.
std::string header_of(const PdmLayout& layout);

/// The checksum of a block, as stored in the file.
std::string checksum_of(std::string_view block);

/// Numbers as stored in the file: coordinates, tags, and vertices in 4 or 8 bytes.
std::string pdm_bytes(const Eigen::Ref<const Points>& points);
std::string pdm_bytes(const std::vector<Index>& tags);
std::string pdm_bytes(const std::vector<std::int64_t>& vertices, std::int64_t bytes_each);

/// Reads any part of a .pdm file, with checks.
class PdmReader {
public:
    /// Throws InvalidInput, naming the file, for another format or length.
    explicit PdmReader(PartialFile file);

    const PdmLayout& layout() const { return layout_; }

    /// The items in [begin, end); for cells their vertices, one after the other. Throw
    /// InvalidInput, naming the file, for a wrong checksum, non-finite coordinates, and vertices
    /// out of range.
    Points points(std::int64_t begin, std::int64_t end) const;
    std::vector<std::int64_t> cells(std::int64_t begin, std::int64_t end) const;
    std::vector<Index> tags(std::int64_t begin, std::int64_t end) const;

private:
    [[noreturn]] void fail(const std::string& text) const;
    std::string checked(std::int64_t begin, std::int64_t end) const;

    PartialFile file_;
    PdmLayout layout_;
};

} // namespace polydec
