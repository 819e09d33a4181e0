// SPDX-License-Identifier: MIT
#include "io/meshes/vtk_source.h"

#include "io/source_file.h"

#include <fmt/format.h>

namespace polydec {

namespace {

/// A vtkIdType is written with 32 bits, whatever it has in memory.
constexpr TypeNames vtk_types{{{"char", "signed_char", "vtktypeint8"},
                               {"unsigned_char", "vtktypeuint8"},
                               {"short", "vtktypeint16"},
                               {"unsigned_short", "vtktypeuint16"},
                               {"int", "vtktypeint32", "vtkidtype"},
                               {"unsigned_int", "vtktypeuint32"},
                               {"long", "long_long", "vtktypeint64"},
                               {"unsigned_long", "unsigned_long_long", "vtktypeuint64"},
                               {"float", "vtktypefloat32"},
                               {"double", "vtktypefloat64"}}};

} // namespace

double VtkSource::read_header() {
    const auto mark = scanner_.word("# vtk DataFile Version");
    for (const char* expected : {"vtk", "datafile", "version"})
        if (mark != "#" || keyword(expected) != expected)
            scanner_.fail("the file does not begin with # vtk DataFile Version; expected a legacy "
                          "VTK file; check the format");
    const double version = scanner_.number("the version");
    if (!(version >= 1.0 && version < 6.0))
        scanner_.fail(fmt::format(
            "version {} of the format; expected 1 to 5.1; save the mesh as .vtu", version));
    scanner_.next_line();
    scanner_.next_line();

    const auto encoding = keyword("ASCII or BINARY");
    if (encoding != "ascii" && encoding != "binary")
        scanner_.fail(fmt::format(
            "found {} after the title; expected ASCII or BINARY; correct the third line",
            quote_word(encoding)));
    is_binary_ = encoding == "binary";
    return version;
}

std::string VtkSource::keyword(std::string_view expected) {
    return lower_case(scanner_.word(expected));
}

std::size_t VtkSource::size(const char* plural) {
    return static_cast<std::size_t>(scanner_.count(plural, 0));
}

std::optional<NumberType> VtkSource::type_of(std::string_view word) {
    return type_named(lower_case(word), vtk_types);
}

NumberType VtkSource::read_type() {
    const auto word = scanner_.word("a type of numbers");
    const auto type = type_of(word);
    if (!type)
        scanner_.fail(fmt::format("{} is not a supported type of numbers; expected float, double, "
                                  "int or another of VTK's types; export it again",
                                  quote_word(word)));
    return *type;
}

std::vector<double> VtkSource::values(NumberType type, std::size_t count) {
    const auto each = is_binary_ ? size_of(type) : 2;
    if (is_binary_)
        scanner_.end_line("the line in front of the numbers");
    scanner_.check_room(count, "numbers", each);
    std::vector<double> values(count);
    if (is_binary_) {
        const auto bytes = scanner_.bytes(count * each, "more numbers");
        for (std::size_t i = 0; i < count; ++i)
            values[i] = value_at(bytes.data() + i * each, type, std::endian::big);
    } else {
        for (auto& value : values)
            value = scanner_.number("a number");
    }
    return values;
}

/// Text has a line for each string. In a binary file the first two bits of a string tell how many
/// bytes its length takes, and the others of these bytes are the length.
void VtkSource::skip_string() {
    if (!is_binary_) {
        scanner_.next_line();
        return;
    }
    const auto first = static_cast<unsigned char>(scanner_.bytes(1, "a string")[0]);
    const std::size_t more = (std::size_t{1} << (3U - (first >> 6U))) - 1;
    std::size_t length = first & 0x3FU;
    for (const char byte : scanner_.bytes(more, "a string"))
        length = length << 8U | static_cast<unsigned char>(byte);
    scanner_.bytes(length, "a string");
}

bool VtkSource::skip(std::string_view type, std::size_t count) {
    const auto name = lower_case(type);
    if (name != "string" && name != "bit")
        return false;
    scanner_.end_line("the line in front of the data");
    constexpr std::size_t bits = 8;
    scanner_.check_room(name == "bit" && is_binary_ ? count / bits : count, "numbers", 1);
    if (name == "bit" && is_binary_)
        scanner_.bytes((count + bits - 1) / bits, "more bits");
    else
        for (std::size_t i = 0; i < count; ++i)
            name == "bit" ? static_cast<void>(scanner_.number("a bit")) : skip_string();
    return true;
}

void VtkSource::skip_metadata() {
    do {
        scanner_.next_line();
    } while (!scanner_.at_line_end());
}

} // namespace polydec
