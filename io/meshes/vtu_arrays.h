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

/// How the binary arrays of a VTU file are written: said by its first tag, and by AppendedData.
struct VtuEncoding {
    std::endian order = std::endian::little;
    std::size_t header_bytes = 4; ///< of the numbers of bytes in front of an array
    bool is_compressed = false;   ///< by zlib, the only compression that is read
    std::string_view appended;    ///< behind the mark _
    bool appended_is_raw = false;
};

/// A DataArray as it stands in the file.
struct VtuText {
    XmlTag tag;
    std::string_view text;
    std::size_t text_line = 1;
    std::optional<double> numbers = {}; ///< how many its piece says it has; lists have any

    std::string name() const { return tag.attribute("Name"); }
};

/// Reads the encoding of the tag VTKFile. Throws InvalidInput if it cannot be read.
VtuEncoding vtu_encoding(const XmlTag& tag, const XmlReader& reader);

/// Where an array stands in AppendedData, by the bytes behind its mark.
struct VtuPlace {
    NumberType type = NumberType::float64;
    std::size_t offset = 0;
};

/// Nothing if it stands in its own tag. Throws InvalidInput, naming the line, for a type that there
/// is not and an offset beyond the data.
std::optional<VtuPlace> vtu_place(const VtuText& array, std::size_t appended_bytes,
                                  const SourceFile& file);

/// About how many bytes of memory the array takes if it is compressed, by what stands in front of
/// it; else 0, for it takes a small multiple of the file. Throws InvalidInput, naming the line of
/// the array, if that is not what its piece says, or more than the file can hold.
double check_vtu_array(const VtuText& array, const VtuEncoding& encoding, const SourceFile& file);

/// The numbers of the array: from text, or from base64 or raw bytes, here or in AppendedData.
/// Throws InvalidInput, naming the line of the array, if they are damaged and, before it inflates
/// anything, like check_vtu_array; IoError if memory does not suffice.
std::vector<double> vtu_values(const VtuText& array, const VtuEncoding& encoding,
                               const SourceFile& file);

} // namespace polydec
