// SPDX-License-Identifier: MIT
#pragma once

#include "io/number_type.h"
#include "io/scanner.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polydec {

/// The words and numbers of a legacy VTK file. After the header, text is a stream of words without
/// line structure; bytes begin after a line.
class VtkSource {
public:
    explicit VtkSource(const Scanner& scanner) : scanner_(scanner) {}

    /// Reads the first lines up to ASCII or BINARY; returns the version.
    double read_header();

    /// The next word in lower case, since keywords are case-insensitive.
    std::string keyword(std::string_view expected);

    /// A count; `values` checks that the file can hold that many bytes.
    std::size_t size(const char* plural);

    /// The type of numbers with this name; none for other words.
    static std::optional<NumberType> type_of(std::string_view word);
    NumberType read_type();

    /// Reads `count` numbers; allocates no more than the file can hold.
    std::vector<double> values(NumberType type, std::size_t count);

    /// Skips strings and bits, which are not numbers. Returns false for other types.
    bool skip(std::string_view type, std::size_t count);

    /// Skips lines of text up to an empty one.
    void skip_metadata();

    bool is_binary() const { return is_binary_; }
    Scanner& scanner() { return scanner_; }

private:
    void skip_string();

    Scanner scanner_;
    bool is_binary_ = false;
};

} // namespace polydec
