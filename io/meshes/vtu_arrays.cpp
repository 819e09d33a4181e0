// SPDX-License-Identifier: MIT
#include "io/meshes/vtu_arrays.h"

#include "base/errors.h"
#include "io/base64.h"
#include "io/deflate.h"
#include "io/scanner.h"
#include "system/memory.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <utility>

namespace polydec {

namespace {

NumberType type_of(const VtuText& array, const Scanner& place) {
    constexpr TypeNames names{{{"Int8"},
                               {"UInt8"},
                               {"Int16"},
                               {"UInt16"},
                               {"Int32"},
                               {"UInt32"},
                               {"Int64"},
                               {"UInt64"},
                               {"Float32"},
                               {"Float64"}}};
    const auto name = array.tag.attribute("type");
    const auto type = type_named(name, names);
    if (!type)
        place.fail(fmt::format("an array of the type {}; expected Float64, Int32 or another type "
                               "of numbers; export it again",
                               quote_word(name)));
    return *type;
}

/// The bytes of an array, one piece after the other.
class ByteSource {
public:
    ByteSource(std::string_view text, bool is_raw, const Scanner& place)
        : raw_(text), base64_(text), is_raw_(is_raw), place_(place) {}

    /// How many bytes follow, at most.
    std::size_t remaining() const { return is_raw_ ? raw_.size() : base64_.remaining(); }

    std::string read(std::size_t bytes) {
        std::string result;
        bool fits = false;
        if (is_raw_) {
            fits = bytes <= raw_.size();
            result = raw_.substr(0, fits ? bytes : 0);
            raw_.remove_prefix(result.size());
        } else {
            fits = base64_.read(bytes, result);
        }
        if (!fits)
            place_.fail(fmt::format("an array ends before {} more bytes, or is not {}; expected "
                                    "all of its bytes; export it again, it seems damaged",
                                    bytes, is_raw_ ? "raw" : "base64"));
        return result;
    }

private:
    std::string_view raw_;
    Base64Reader base64_;
    bool is_raw_;
    const Scanner& place_;
};

/// Takes the bytes of one array apart.
class ArrayDecoder {
public:
    ArrayDecoder(ByteSource source, const VtuEncoding& encoding, const Scanner& place)
        : source_(source), encoding_(encoding), place_(place) {
        (encoding.is_compressed ? blocks_ : size_) = header();
        if (blocks_ > 0) {
            size_ = header();
            last_size_ = header();
        }
    }

    /// How many bytes the array has, by what stands in front of it.
    double promised() const {
        if (!encoding_.is_compressed)
            return static_cast<double>(size_);
        return (static_cast<double>(blocks_) - 1) * static_cast<double>(size_) +
               static_cast<double>(last_size_ == 0 ? size_ : last_size_);
    }

    /// How many bytes the rest of the file can give.
    double capacity() const {
        return (encoding_.is_compressed ? most_inflated_per_byte : 1) *
               static_cast<double>(source_.remaining());
    }

    std::string bytes() { return encoding_.is_compressed ? inflated() : source_.read(size_); }

private:
    std::size_t header() {
        const auto number = source_.read(encoding_.header_bytes);
        return encoding_.header_bytes == sizeof(std::uint64_t)
                   ? number_at<std::uint64_t>(number.data(), encoding_.order)
                   : number_at<std::uint32_t>(number.data(), encoding_.order);
    }

    std::string inflated() {
        std::vector<std::size_t> sizes;
        for (std::size_t block = 0; block < blocks_; ++block)
            sizes.push_back(header());
        std::string result;
        for (std::size_t block = 0; block < blocks_; ++block) {
            const bool is_smaller = block + 1 == blocks_ && last_size_ != 0;
            const auto content =
                inflate(source_.read(sizes[block]), is_smaller ? last_size_ : size_);
            if (!content)
                place_.fail(fmt::format("block {} of a compressed array is damaged; expected a "
                                        "zlib stream of the announced size; export it again",
                                        block));
            result += *content;
        }
        return result;
    }

    ByteSource source_;
    const VtuEncoding& encoding_;
    const Scanner& place_;
    // In front of a compressed array: the number of blocks, the size of each, the size of the last
    // if it is smaller, and the compressed size of each. Of others it is their size.
    std::size_t blocks_ = 0, size_ = 0, last_size_ = 0;
};

std::vector<double> values_from_text(Scanner scanner) {
    std::vector<double> values;
    while (!scanner.at_end())
        values.push_back(scanner.number("a number"));
    return values;
}

std::size_t offset_of(const VtuText& array, std::size_t appended_bytes, const Scanner& place) {
    const auto offset = array.tag.attribute("offset", "x");
    std::size_t begin = 0;
    const auto result = std::from_chars(offset.data(), offset.data() + offset.size(), begin);
    if (result.ec != std::errc{} || result.ptr != offset.data() + offset.size() ||
        begin >= appended_bytes)
        place.fail(fmt::format("the offset {} of an array in AppendedData; expected a number below "
                               "{}; export it again, it seems cut off",
                               quote_word(offset), appended_bytes));
    return begin;
}

Scanner place_of(const VtuText& array, const SourceFile& file) {
    Scanner place(file.name, array.text);
    place.set_line(array.text_line);
    return place;
}

void check_count(double numbers, const VtuText& array, const Scanner& place) {
    if (array.numbers && numbers != *array.numbers)
        place.fail(fmt::format("the array {} has {} numbers; expected {:.0f}, from the numbers of "
                               "points, cells and corners of its piece; export it again",
                               quote_word(array.name()), numbers, *array.numbers));
}

/// How many bytes an array needs, by what stands in front of it: a small stream can inflate to a
/// thousand times its size, and a small file tell of any numbers.
double memory_of(const ArrayDecoder& decoder, const VtuText& array, const Scanner& place) {
    const double promised = decoder.promised();
    const auto each = static_cast<double>(size_of(type_of(array, place)));
    check_count(promised / each, array, place);
    if (promised > decoder.capacity())
        place.fail(fmt::format(
            "the array {} announces {:.0f} bytes; expected at most {:.0f}, the capacity "
            "of the rest of the file; export it again, it seems cut off",
            quote_word(array.name()), promised, decoder.capacity()));
    return promised * (1 + static_cast<double>(sizeof(double)) / each);
}

/// The bytes of an array that is not text.
ArrayDecoder decoder_of(const VtuText& array, const VtuEncoding& encoding, const Scanner& place) {
    const auto format = array.format();
    const bool is_appended = format == "appended";
    if (!is_appended && format != "binary")
        place.fail(fmt::format("an array in the format {}; expected ascii, binary or appended; "
                               "export it again",
                               quote_word(format)));
    const auto begin = is_appended ? offset_of(array, encoding.appended.size(), place) : 0;
    return {{is_appended ? encoding.appended.substr(begin) : array.text,
             is_appended && encoding.appended_is_raw, place},
            encoding,
            place};
}

} // namespace

VtuEncoding vtu_encoding(const XmlTag& tag, const XmlReader& reader) {
    VtuEncoding encoding;
    const auto order = tag.attribute("byte_order", "LittleEndian");
    const auto header = tag.attribute("header_type", "UInt32");
    const auto compressor = tag.attribute("compressor");
    if (order != "LittleEndian" && order != "BigEndian")
        reader.fail(fmt::format("the order of bytes {}; expected LittleEndian or BigEndian; export "
                                "it again",
                                quote_word(order)));
    if (header != "UInt32" && header != "UInt64")
        reader.fail(fmt::format("the header_type {}; expected UInt32 or UInt64; export it again",
                                quote_word(header)));
    if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
        reader.fail(fmt::format("the arrays are compressed by {}; expected vtkZLibDataCompressor "
                                "or none; export it again without compression",
                                quote_word(compressor)));
    encoding.order = order == "BigEndian" ? std::endian::big : std::endian::little;
    encoding.header_bytes = header == "UInt64" ? 8 : 4;
    encoding.is_compressed = !compressor.empty();
    return encoding;
}

std::optional<VtuPlace> vtu_place(const VtuText& array, std::size_t appended_bytes,
                                  const SourceFile& file) {
    if (array.format() != "appended")
        return std::nullopt;
    const Scanner place = place_of(array, file);
    return VtuPlace{type_of(array, place), offset_of(array, appended_bytes, place)};
}

double check_vtu_array(const VtuText& array, const VtuEncoding& encoding, const SourceFile& file) {
    if (!encoding.is_compressed || array.format() == "ascii")
        return 0;
    const Scanner place = place_of(array, file);
    return memory_of(decoder_of(array, encoding, place), array, place);
}

std::vector<double> vtu_values(const VtuText& array, const VtuEncoding& encoding,
                               const SourceFile& file) {
    const Scanner place = place_of(array, file);
    const auto type = type_of(array, place);
    if (array.format() == "ascii") {
        auto values = values_from_text(place);
        check_count(static_cast<double>(values.size()), array, place);
        return values;
    }
    ArrayDecoder decoder = decoder_of(array, encoding, place);
    check_memory(memory_of(decoder, array, place),
                 fmt::format("{}: the array {}", file.name, quote_word(array.name())));
    const auto bytes = decoder.bytes();
    const auto each = size_of(type);
    if (bytes.size() % each != 0)
        place.fail(fmt::format(
            "an array has {} bytes, and each number needs {}; expected a multiple; export it again",
            bytes.size(), each));
    std::vector<double> values(bytes.size() / each);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = value_at(bytes.data() + i * each, type, encoding.order);
    return values;
}

} // namespace polydec
