// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace polydec {

/// Reads words and numbers from a text, never beyond its end, and knows the line for messages.
/// Lines end with LF, CR LF or CR. A copy is a bookmark: it goes on from the same place.
/// Every function that reads throws InvalidInput "name:line: ..." where the text does not fit.
class Scanner {
public:
    /// What differs from format to format; '\0' for what a format does not have.
    struct Syntax {
        char comment = '\0';      ///< from here, at the beginning of a word, to the end of the line
        char continuation = '\0'; ///< at the end of a line: the next line belongs to it
    };

    /// Both name and text must outlive the scanner.
    Scanner(std::string_view name, std::string_view text, Syntax syntax);
    Scanner(std::string_view name, std::string_view text) : Scanner(name, text, Syntax{}) {}

    /// Goes to the next word on any line; true where there is none.
    bool at_end();

    /// Goes to the next word on this line; true where there is none.
    bool at_line_end();

    /// Goes behind the end of this line.
    void next_line();

    /// The next word on any line; `expected` says what it should be, for the message at the end.
    std::string_view word(std::string_view expected);

    /// The next word on any line as a number, which may be infinite or NaN. Its exponent may stand
    /// behind a D, as Fortran writes it.
    double number(std::string_view expected);

    /// The next word on any line as a whole number. It may also end before `end_mark`.
    std::int64_t integer(std::string_view expected, char end_mark = '\0');

    /// The next word as a finite coordinate of the vertex with this number.
    double coordinate(Index vertex);

    /// The next word as a number of records of which each takes at least `least_bytes` bytes:
    /// refuses more than the rest of the text can hold, so that it is safe to allocate. With 0
    /// bytes the caller has to find out.
    Index count(std::string_view plural, std::size_t least_bytes);

    /// The next word as a vertex number from `first` to `first + vertices - 1`; minus `first`.
    Index vertex(Index vertices, Index first);

    /// The same checks for numbers that were read already.
    double as_coordinate(double value, Index vertex) const;
    Index as_count(std::int64_t value, std::string_view plural, std::size_t least_bytes) const;
    Index as_vertex(std::int64_t value, Index vertices, Index first) const;

    /// The next bytes, whatever they are; LF among them counts as the end of a line.
    std::string_view bytes(std::size_t count, std::string_view expected);

    /// Refuses the end of the line where `record` goes on.
    void stay_on_line(std::string_view record);

    /// Refuses further words on this line, and goes behind its end.
    void end_line(std::string_view record);

    /// Goes behind the next `bytes` bytes, which must be there and hold no line break.
    void skip(std::size_t bytes) { position_ += bytes; }

    /// Throws InvalidInput "name:line: text"; the text says what is, what should be, what to do.
    [[noreturn]] void fail(const std::string& text) const;

    /// For a text that is the later part of a file.
    void set_line(std::size_t line) { line_ = line; }

    /// For a text that is the first part of a file: so many bytes stand behind it, which may hold
    /// records too.
    void set_bytes_behind(std::size_t bytes) { behind_ = bytes; }
    std::size_t line() const { return line_; }
    std::size_t remaining() const { return static_cast<std::size_t>(end_ - position_); }
    std::size_t bytes_to_come() const { return remaining() + behind_; } ///< of the file
    std::string_view name() const { return name_; }
    std::string_view rest() const { return {position_, remaining()}; }

private:
    bool is_line_break(char c) const { return c == '\n' || c == '\r'; }
    bool is_space(char c) const { return c == ' ' || (c >= '\t' && c <= '\r'); }
    bool continues_here() const;
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

/// A word of a file for a message: in quotes, printable and of bounded length.
std::string quote_word(std::string_view word);

} // namespace polydec
