// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace polydec {

/// Reads words and numbers from a text, never beyond its end, and tracks the line for messages.
/// Lines end with LF, CR LF or CR. A copy is a bookmark: it resumes at the same place. Every
/// reading function throws InvalidInput "name:line: ..." for malformed text.
class Scanner {
public:
    /// Format-dependent characters; '\0' if the format has none.
    struct Syntax {
        char comment = '\0';      ///< at the start of a word: comments out the rest of the line
        char continuation = '\0'; ///< at the end of a line: the next line belongs to it
    };

    /// Both name and text must outlive the scanner.
    Scanner(std::string_view name, std::string_view text, Syntax syntax);
    Scanner(std::string_view name, std::string_view text) : Scanner(name, text, Syntax{}) {}

    /// Moves to the next word on any line; true if there is none.
    bool at_end();

    /// Moves to the next word on this line; true if there is none.
    bool at_line_end();

    /// Moves past the end of this line.
    void next_line();

    /// The next word on any line; `expected` describes it in the message at the end of the text.
    std::string_view word(std::string_view expected);

    /// The next word on any line as a number, which may be infinite or NaN. The exponent may follow
    /// a D, as in Fortran.
    double number(std::string_view expected);

    /// The next word on any line as an integer. It may also end before `end_mark`.
    std::int64_t integer(std::string_view expected, char end_mark = '\0');

    /// The next word as a finite coordinate of the vertex with this number.
    double coordinate(Index vertex);

    /// The next word as a number of records of at least `least_bytes` bytes each. Throws if the
    /// rest of the text cannot hold them, so that allocation is safe. With 0 bytes the caller must
    /// check.
    Index count(std::string_view plural, std::size_t least_bytes);

    /// The next word as a vertex number from `first` to `first + vertices - 1`; minus `first`.
    Index vertex(Index vertices, Index first);

    /// The same checks for numbers that were already read.
    double as_coordinate(double value, Index vertex) const;
    Index as_count(std::int64_t value, std::string_view plural, std::size_t least_bytes) const;

    /// Throws if the rest of the file cannot hold this number of records of at least `least_bytes`
    /// bytes each, above 0.
    void check_room(std::uint64_t count, std::string_view plural, std::size_t least_bytes) const;

    /// The next bytes, unrestricted; LF among them counts as the end of a line.
    std::string_view bytes(std::size_t count, std::string_view expected);

    /// Throws at the end of the line, within a record.
    void stay_on_line(std::string_view record);

    /// Throws for further words on this line, and moves past its end.
    void end_line(std::string_view record);

    /// Moves past the next `bytes` bytes, which must exist and hold no line break.
    void skip(std::size_t bytes) { position_ += bytes; }

    /// Throws InvalidInput "name:line: text"; the text gives the fault, the expectation and advice.
    [[noreturn]] void fail(const std::string& text) const;

    /// For a text that is the later part of a file.
    void set_line(std::size_t line) { line_ = line; }

    /// For a text that is the first part of a file: this many bytes follow it, which may also hold
    /// records.
    void set_bytes_behind(std::size_t bytes) { behind_ = bytes; }
    std::size_t line() const { return line_; }
    std::size_t remaining() const { return static_cast<std::size_t>(end_ - position_); }
    std::size_t bytes_to_come() const { return remaining() + behind_; } ///< of the file
    std::string_view name() const { return name_; }
    std::string_view rest() const { return {position_, remaining()}; }

private:
    bool is_line_break(char c) const { return c == '\n' || c == '\r'; }
    bool is_space(char c) const { return c == ' ' || (c >= '\t' && c <= '\r'); }
    bool continues_at(const char* place) const;
    bool ends_word(const char* place) const;
    void go_to_word(std::string_view expected);
    double fortran_number(std::string_view expected);
    void skip_blanks();
    void skip_line_break();
    std::string_view word_here() const;
    [[noreturn]] void fail_at_word(std::string_view problem, std::string_view expected) const;

    std::string_view name_;
    const char* position_;
    const char* end_;
    std::size_t line_ = 1;
    std::size_t behind_ = 0;
    Syntax syntax_;
};

/// A word of a file, quoted for a message: printable and of bounded length.
std::string quote_word(std::string_view word);

} // namespace polydec
