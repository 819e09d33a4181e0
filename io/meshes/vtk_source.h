// SPDX-License-Identifier: MIT
#pragma once

#include "io/number_type.h"
#include "io/scanner.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace polydec {

/// The words and numbers of a legacy VTK file. Behind the header, text is a stream of words whose
/// lines mean nothing; bytes begin behind a line.
class VtkSource {
public:
    explicit VtkSource(const Scanner& scanner) : scanner_(scanner) {}

    /// The first lines up to ASCII or BINARY. The version.
    double read_header();

    /// The next word in small letters, since keywords may be written in any case.
    std::string keyword(std::string_view expected);

    /// A number of things; how many bytes these take is checked by `values`.
    std::size_t size(const char* plural);

    /// A type of numbers by its name; nothing if there is none.
    static std::optional<NumberType> type_of(std::string_view word);
    NumberType read_type();

    /// So many numbers; nothing is allocated that the file cannot hold.
    std::vector<double> values(NumberType type, std::size_t count);

    /// Passes over strings and over bits, which stand for no numbers. False for other types.
    bool skip(std::string_view type, std::size_t count);

    /// Lines of text up to an empty one.
    void skip_metadata();

    bool is_binary() const { return is_binary_; }
    Scanner& scanner() { return scanner_; }

private:
    void check_room(std::size_t count, std::size_t each);
    void skip_string();

    Scanner scanner_;
    bool is_binary_ = false;
};

/// A word in small letters.
std::string lower_case(std::string_view word);

} // namespace polydec
