// SPDX-License-Identifier: MIT
#include "io/meshes/vtu_arrays.h"

#include "base/errors.h"
#include "base/memory.h"
#include "io/base64.h"
#include "io/inflate.h"
#include "io/scanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <utility>

namespace polydec {

namespace {

NumberType type_of(const std::string& name, const Scanner& place) {
    constexpr std::array<std::pair<std::string_view, NumberType>, 10> names{
        {{"Int8", NumberType::int8},
         {"UInt8", NumberType::uint8},
         {"Int16", NumberType::int16},
         {"UInt16", NumberType::uint16},
         {"Int32", NumberType::int32},
         {"UInt32", NumberType::uint32},
         {"Int64", NumberType::int64},
         {"UInt64", NumberType::uint64},
         {"Float32", NumberType::float32},
         {"Float64", NumberType::float64}}};
    const auto found = std::find_if(names.begin(), names.end(),
                                    [&name](const auto& one) { return one.first == name; });
    if (found == names.end()) {
        place.fail(fmt::format("an array of the type {}; expected Float64, Int32 or another type "
                               "of numbers; export it again",
                               quote_word(name)));
    }
    return found->second;
}

/// The bytes of an array, one piece after the other.
class ByteSource {
public:
    ByteSource(std::string_view text, bool is_raw, const Scanner& place)
        : raw_(text), base64_(text), is_raw_(is_raw), place_(place) {}

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
        if (!fits) {
            place_.fail(fmt::format("an array ends before {} more bytes, or is not {}; expected "
                                    "all of its bytes; export it again, it seems damaged",
                                    bytes, is_raw_ ? "raw" : "base64"));
        }
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
        : source_(source), encoding_(encoding), place_(place) {}

    /// Asks `check` before it inflates to so many bytes.
    template <typename Check>
    std::string bytes(Check check) {
        return encoding_.is_compressed ? compressed_bytes(check) : source_.read(header());
    }

private:
    std::size_t header() {
        const auto number = source_.read(encoding_.header_bytes);
        return encoding_.header_bytes == sizeof(std::uint64_t)
                   ? number_at<std::uint64_t>(number.data(), encoding_.order)
                   : number_at<std::uint32_t>(number.data(), encoding_.order);
    }

    /// In front: the number of blocks, the size of each, the size of the last if it is smaller,
    /// and the compressed size of each.
    template <typename Check>
    std::string compressed_bytes(Check check) {
        const auto blocks = header();
        if (blocks == 0)
            return {};
        const auto size = header();
        const auto last_size = header();
        check(static_cast<double>(blocks - 1) * static_cast<double>(size) +
              static_cast<double>(last_size == 0 ? size : last_size));
        std::vector<std::size_t> sizes;
        for (std::size_t block = 0; block < blocks; ++block)
            sizes.push_back(header());
        std::string result;
        for (std::size_t block = 0; block < blocks; ++block) {
            const bool is_smaller = block + 1 == blocks && last_size != 0;
            const auto content = inflate(source_.read(sizes[block]), is_smaller ? last_size : size);
            if (!content) {
                place_.fail(fmt::format("block {} of a compressed array is damaged; expected a "
                                        "zlib stream of the size that is promised; export it "
                                        "again",
                                        block));
            }
            result += *content;
        }
        return result;
    }

    ByteSource source_;
    const VtuEncoding& encoding_;
    const Scanner& place_;
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
        begin >= appended_bytes) {
        place.fail(fmt::format("the offset {} of an array in AppendedData; expected a number below "
                               "{}; export it again, it seems cut off",
                               quote_word(offset), appended_bytes));
    }
    return begin;
}

/// A small stream can inflate to a thousand times its size.
void check_promise(const VtuText& array, double promised, double most, const Scanner& place) {
    if (!(promised <= most)) {
        place.fail(fmt::format("the compressed array {} promises {:.0f} bytes; expected at most "
                               "{:.0f}, by the numbers of points, cells and corners of its piece; "
                               "export it again",
                               quote_word(array.name()), promised, most));
    }
}

Scanner place_of(const VtuText& array, const SourceFile& file) {
    Scanner place(file.name, array.text);
    place.set_line(array.text_line);
    return place;
}

} // namespace

VtuEncoding vtu_encoding(const XmlTag& tag, const XmlReader& reader) {
    VtuEncoding encoding;
    const auto order = tag.attribute("byte_order", "LittleEndian");
    const auto header = tag.attribute("header_type", "UInt32");
    const auto compressor = tag.attribute("compressor");
    if (order != "LittleEndian" && order != "BigEndian") {
        reader.fail(fmt::format("the order of bytes {}; expected LittleEndian or BigEndian; export "
                                "it again",
                                quote_word(order)));
    }
    if (header != "UInt32" && header != "UInt64") {
        reader.fail(fmt::format("the header_type {}; expected UInt32 or UInt64; export it again",
                                quote_word(header)));
    }
    if (!compressor.empty() && compressor != "vtkZLibDataCompressor") {
        reader.fail(fmt::format("the arrays are compressed by {}; expected vtkZLibDataCompressor "
                                "or none; export it again without compression",
                                quote_word(compressor)));
    }
    encoding.order = order == "BigEndian" ? std::endian::big : std::endian::little;
    encoding.header_bytes = header == "UInt64" ? 8 : 4;
    encoding.is_compressed = !compressor.empty();
    return encoding;
}

std::optional<VtuPlace> vtu_place(const VtuText& array, std::size_t appended_bytes,
                                  const SourceFile& file) {
    if (array.tag.attribute("format", "ascii") != "appended")
        return std::nullopt;
    const Scanner place = place_of(array, file);
    return VtuPlace{type_of(array.tag.attribute("type"), place),
                    offset_of(array, appended_bytes, place)};
}

std::vector<double> vtu_values(const VtuText& array, double most, const VtuEncoding& encoding,
                               const SourceFile& file) {
    const Scanner place = place_of(array, file);
    const auto format = array.tag.attribute("format", "ascii");
    const auto type = type_of(array.tag.attribute("type"), place);
    if (format == "ascii")
        return values_from_text(place);
    const bool is_appended = format == "appended";
    if (!is_appended && format != "binary") {
        place.fail(fmt::format("an array in the format {}; expected ascii, binary or appended; "
                               "export it again",
                               quote_word(format)));
    }
    const ByteSource source(
        is_appended ? encoding.appended.substr(offset_of(array, encoding.appended.size(), place))
                    : array.text,
        is_appended && encoding.appended_is_raw, place);
    const auto each = size_of(type);
    const auto bytes = ArrayDecoder(source, encoding, place).bytes([&](double promised) {
        check_promise(array, promised, most * static_cast<double>(each), place);
        const double as_numbers = promised / static_cast<double>(each) * sizeof(double);
        check_memory(promised + as_numbers,
                     fmt::format("{}: the array {}", file.name, quote_word(array.name())));
    });
    if (bytes.size() % each != 0) {
        place.fail(fmt::format("an array of {} bytes, of which each number takes {}; expected a "
                               "multiple; export it again",
                               bytes.size(), each));
    }
    std::vector<double> values(bytes.size() / each);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = value_at(bytes.data() + i * each, type, encoding.order);
    return values;
}

} // namespace polydec
