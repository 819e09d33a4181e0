// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"
#include "io/number_type.h"
#include "io/source_file.h"

#include <bit>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace polydec {

/// A number, or a list of numbers preceded by its length.
struct PlyProperty {
    std::string name;
    NumberType type = NumberType::float32;
    NumberType length_type = NumberType::uint8; ///< of a list
    bool is_list = false;
};

struct PlyElement {
    std::string name;
    Index count = 0;
    std::vector<PlyProperty> properties;

    /// The index of the property in the list, or the number of properties.
    std::size_t find(const std::string& property) const;

    /// The index of the property with the corners of faces, under either of its names.
    std::size_t corners() const;
};

struct PlyHeader {
    std::optional<std::endian> order = {}; ///< of bytes; none in a text file
    std::vector<PlyElement> elements;
    std::size_t body_begin = 0; ///< first byte after the header
    std::size_t body_line = 1;  ///< its line
};

/// Reads the header. `bytes_behind` is the size of the file after this text. Throws InvalidInput,
/// naming the line, also for element counts that the rest of the file cannot hold.
PlyHeader read_ply_header(const SourceFile& file, std::size_t bytes_behind = 0);

} // namespace polydec
