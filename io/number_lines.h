// SPDX-License-Identifier: MIT
#pragma once

#include "io/number_text.h"
#include "system/atomic_file.h"

namespace polydec {

/// A text file of numbers, separated by blanks. Appears whole or not at all.
class NumberLines {
public:
    explicit NumberLines(const std::filesystem::path& path) : file_(path) {}

    /// Whole lines of text.
    void text(std::string_view text) { file_.write(text); }

    void word(std::string_view word) { line_ += word; }

    template <typename Number>
    void number(Number value) {
        line_ += line_.empty() ? "" : " ";
        append_number(line_, value);
    }

    /// The numbers of a range.
    template <typename Range>
    void numbers(const Range& values) {
        for (const auto value : values)
            number(value);
    }

    /// These numbers as a line.
    template <typename... Numbers>
    void line(Numbers... values) {
        (number(values), ...);
        end();
    }

    void end() {
        line_ += '\n';
        file_.write(line_);
        line_.clear();
    }

    void commit() { file_.commit(); }

private:
    AtomicFile file_;
    std::string line_;
};

} // namespace polydec
