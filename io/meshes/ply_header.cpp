// SPDX-License-Identifier: MIT
#include "io/meshes/ply_header.h"

#include "io/scanner.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace polydec {

namespace {

constexpr TypeNames type_names{{{"char", "int8"},
                                {"uchar", "uint8"},
                                {"short", "int16"},
                                {"ushort", "uint16"},
                                {"int", "int32"},
                                {"uint", "uint32"},
                                {},
                                {},
                                {"float", "float32"},
                                {"double", "float64"}}};

NumberType read_type(Scanner& scanner) {
    scanner.stay_on_line("a type");
    const auto word = scanner.word("a type");
    const auto type = type_named(word, type_names);
    if (!type)
        scanner.fail(fmt::format("{} is not a type of PLY; expected char, uchar, short, ushort, "
                                 "int, uint, float or double; correct the header",
                                 quote_word(word)));
    return *type;
}

/// The order of bytes, or none for text.
std::optional<std::endian> read_encoding(Scanner& scanner) {
    const auto word = scanner.word("the encoding");
    if (word == "ascii")
        return std::nullopt;
    if (word == "binary_little_endian")
        return std::endian::little;
    if (word == "binary_big_endian")
        return std::endian::big;
    scanner.fail(fmt::format("{} is not an encoding of PLY; expected ascii, binary_little_endian "
                             "or binary_big_endian; correct the header",
                             quote_word(word)));
}

PlyProperty read_property(Scanner& scanner) {
    PlyProperty property;
    scanner.stay_on_line("a type");
    property.is_list = Scanner(scanner).word("a type") == "list";
    if (property.is_list) {
        scanner.word("list");
        property.length_type = read_type(scanner);
        if (property.length_type == NumberType::float32 ||
            property.length_type == NumberType::float64)
            scanner.fail("the length of a list is a floating-point number; expected a whole "
                         "number's type; correct the header");
    }
    property.type = read_type(scanner);
    scanner.stay_on_line("the name of a property");
    property.name = scanner.word("the name of a property");
    return property;
}

/// A record without properties takes no bytes in a binary file: nothing bounds its count, and it
/// can be passed over. Errors are of the line of the element.
void check_count(Scanner scanner, const PlyElement& element, bool is_binary, std::size_t line) {
    std::size_t bytes = 0;
    for (const auto& property : element.properties) {
        const auto type = property.is_list ? property.length_type : property.type;
        bytes += is_binary ? size_of(type) : 2;
    }
    scanner.set_line(line);
    if (bytes > 0)
        scanner.check_room(element.count, fmt::format("elements {}", quote_word(element.name)),
                           bytes);
}

class HeaderReader {
public:
    HeaderReader(const SourceFile& file, std::size_t bytes_behind)
        : file_(file), scanner_(file.name, file.text) {
        scanner_.set_bytes_behind(bytes_behind);
    }

    PlyHeader read() {
        begin();
        while (read_line()) {
        }
        end();
        return std::move(header_);
    }

private:
    void begin() {
        if (scanner_.at_end() || scanner_.word("ply") != "ply")
            scanner_.fail("the file does not begin with the word ply; expected a PLY file; check "
                          "the format");
        scanner_.end_line("the first line, ply");
    }

    /// False for the line that ends the header.
    bool read_line() {
        const auto keyword = scanner_.word("end_header");
        if (keyword == "end_header")
            return false;
        if (keyword == "format") {
            header_.order = read_encoding(scanner_);
            has_format_ = true;
        } else if (keyword == "element") {
            read_element();
        } else if (keyword == "property") {
            if (header_.elements.empty())
                scanner_.fail("a property stands before the first element; expected an element; "
                              "correct the header");
            header_.elements.back().properties.push_back(read_property(scanner_));
        } else if (keyword != "comment" && keyword != "obj_info") {
            scanner_.fail(fmt::format("{} is not a keyword of PLY; expected format, comment, "
                                      "element, property or end_header; correct the header",
                                      quote_word(keyword)));
        }
        scanner_.next_line();
        return true;
    }

    void read_element() {
        PlyElement element;
        scanner_.stay_on_line("the name of an element");
        element.name = scanner_.word("the name of an element");
        for (const auto& other : header_.elements)
            if (other.name == element.name)
                scanner_.fail(
                    fmt::format("the element {} occurs twice; expected it once; correct the header",
                                quote_word(element.name)));
        scanner_.stay_on_line("the number of elements");
        element.count = scanner_.count(fmt::format("elements {}", quote_word(element.name)), 0);
        header_.elements.push_back(std::move(element));
        lines_.push_back(scanner_.line());
    }

    /// Only one line break belongs to the header: what follows may be binary.
    void end() {
        if (!has_format_)
            scanner_.fail("the header names no format; expected a line such as format ascii 1.0; "
                          "correct the header");
        const auto text = scanner_.rest();
        const auto line_break = text.find_first_of("\r\n");
        if (line_break == std::string_view::npos)
            scanner_.fail("the file ends with its header; expected the elements; export it again, "
                          "it seems cut off");
        const bool two = !breaks_lines_with_cr() && text.substr(line_break, 2) == "\r\n";
        scanner_.skip(line_break);
        header_.body_begin = file_.text.size() - scanner_.remaining() + (two ? 2 : 1);
        header_.body_line = scanner_.line() + 1;
        for (std::size_t i = 0; i < header_.elements.size(); ++i)
            check_count(scanner_, header_.elements[i], header_.order.has_value(), lines_[i]);
    }

    /// The first line decides: after a lone CR a binary body may begin with the byte of LF. Where
    /// lines end with LF, a CR in front of it belongs to the line.
    bool breaks_lines_with_cr() const {
        const auto first = file_.text.find_first_of("\r\n");
        return file_.text[first] == '\r' && file_.text.compare(first, 2, "\r\n") != 0;
    }

    const SourceFile& file_;
    Scanner scanner_;
    PlyHeader header_;
    std::vector<std::size_t> lines_;
    bool has_format_ = false;
};

} // namespace

std::size_t PlyElement::find(const std::string& property) const {
    const auto found =
        std::find_if(properties.begin(), properties.end(),
                     [&property](const PlyProperty& each) { return each.name == property; });
    return static_cast<std::size_t>(found - properties.begin());
}

std::size_t PlyElement::corners() const {
    const auto list = find("vertex_indices");
    return list < properties.size() ? list : find("vertex_index");
}

PlyHeader read_ply_header(const SourceFile& file, std::size_t bytes_behind) {
    return HeaderReader(file, bytes_behind).read();
}

} // namespace polydec
