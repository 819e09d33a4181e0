// SPDX-License-Identifier: MIT
#pragma once

#include "io/number_type.h"
#include "io/source_file.h"
#include "io/xml_reader.h"

#include <bit>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polydec {

/// The encoding of binary arrays in a VTU file, from its first tag and AppendedData.
struct VtuEncoding {
    std::endian order = std::endian::little;
    std::size_t header_bytes = 4; ///< of the byte counts before an array
    bool is_compressed = false;   ///< by zlib, the only supported compression
    std::string_view appended;    ///< after the mark _
    bool appended_is_raw = false;
};

/// A DataArray as stored in the file.
struct VtuText {
    XmlTag tag;
    std::string_view text;
    std::size_t text_line = 1;
    std::optional<double> numbers = {}; ///< count stated by its piece; lists have any

    std::string name() const { return tag.attribute("Name"); }
    std::string format() const { return tag.attribute("format", "ascii"); }
};

/// Reads the encoding of the tag VTKFile. Throws InvalidInput if it cannot be read.
VtuEncoding vtu_encoding(const XmlTag& tag, const XmlReader& reader);

/// The place of an array in AppendedData, in bytes after its mark.
struct VtuPlace {
    NumberType type = NumberType::float64;
    std::size_t offset = 0;
};

/// None if the array is inline. Throws InvalidInput, naming the line, for an unknown type and an
/// offset beyond the data.
std::optional<VtuPlace> vtu_place(const VtuText& array, std::size_t appended_bytes,
                                  const SourceFile& file);

/// The approximate memory in bytes that a compressed array needs, from its header; 0 for others,
/// which need a small multiple of the file. Throws InvalidInput, naming the line of the array, if
/// its size contradicts its piece or exceeds what the file can hold.
double check_vtu_array(const VtuText& array, const VtuEncoding& encoding, const SourceFile& file);

/// The numbers of the array: from text, base64 or raw bytes, inline or in AppendedData. Throws
/// InvalidInput, naming the line of the array, if they are damaged and, before inflating anything,
/// like check_vtu_array; IoError if memory is insufficient.
std::vector<double> vtu_values(const VtuText& array, const VtuEncoding& encoding,
                               const SourceFile& file);

} // namespace polydec
