// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"
#include "io/number_type.h"
#include "io/source_file.h"

#include <cstddef>
#include <string>
#include <vector>

namespace polydec {

enum class PlyEncoding { ascii, little_endian, big_endian };

/// A number, or a list of numbers with its length in front.
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

    /// The place of the property in the list, or the number of properties.
    std::size_t find(const std::string& property) const;

    /// That of the corners of faces, by either of its names.
    std::size_t corners() const;
};

struct PlyHeader {
    PlyEncoding encoding = PlyEncoding::ascii;
    std::vector<PlyElement> elements;
    std::size_t body_begin = 0; ///< byte behind the header
    std::size_t body_line = 1;  ///< its line
};

/// Reads the header. Element counts are refused where the rest of the file, of which so many bytes
/// stand behind this text, cannot hold them. Throws InvalidInput, naming the line.
PlyHeader read_ply_header(const SourceFile& file, std::size_t bytes_behind = 0);

} // namespace polydec
