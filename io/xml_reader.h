// SPDX-License-Identifier: MIT
#pragma once

#include "io/scanner.h"
#include "io/source_file.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace polydec {

/// A tag such as <name key="value">, </name> or <name/>.
struct XmlTag {
    std::string_view name;
    std::vector<std::pair<std::string_view, std::string>> attributes;
    bool opens = false;
    bool closes = false;
    std::size_t line = 1;

    /// The value of the attribute, or `missing` if it is absent.
    std::string attribute(std::string_view key, std::string_view missing = "") const;
};

/// Reads XML tag by tag and checks that tags match. Skips comments and declarations; CDATA and
/// DOCTYPE are errors. Every reading function throws InvalidInput "name:line: ..." for malformed
/// text.
class XmlReader {
public:
    /// The file must outlive the reader.
    explicit XmlReader(const SourceFile& file) : scanner_(file.name, file.text) {}

    /// Moves past the next tag; false at the end of the text.
    bool next(XmlTag& tag);

    /// The text before the last tag, verbatim, and its first line.
    std::string_view text() const { return text_; }
    std::size_t text_line() const { return text_line_; }

    /// The text after the last tag.
    std::string_view rest() const { return scanner_.rest(); }

    /// The names of the open elements, from outside in.
    const std::vector<std::string_view>& path() const { return path_; }

    [[noreturn]] void fail(const std::string& text) const { scanner_.fail(text); }

private:
    void go_to_tag();
    void pass(std::size_t bytes) { scanner_.bytes(bytes, ""); }
    void pass_over(std::string_view end);
    void skip_spaces();
    bool starts_with(std::string_view word) const;
    std::string_view read_name();
    std::string read_value();
    void read_attributes(XmlTag& tag);
    void keep_path(const XmlTag& tag);

    Scanner scanner_;
    std::string_view text_;
    std::size_t text_line_ = 1;
    std::vector<std::string_view> path_;
};

} // namespace polydec
