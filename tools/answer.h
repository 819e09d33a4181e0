// SPDX-License-Identifier: MIT
#pragma once

#include "io/json_writer.h"

#include <fmt/format.h>

#include <chrono>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace polydec::tools {

/// Seconds per stage, in the order the stages began. A stage lasts until the next one begins; one
/// that begins again goes on.
class Timing {
public:
    void begin(std::string_view stage);
    void end();
    const std::vector<std::pair<std::string, double>>& seconds() const { return seconds_; }

private:
    using Clock = std::chrono::steady_clock;
    std::vector<std::pair<std::string, double>> seconds_;
    std::optional<std::size_t> running_;
    Clock::time_point since_;
};

/// What is told on the way to every answer, and in its JSON object too.
struct Log {
    Timing timing = {};
    std::vector<std::string> warnings = {};

    /// Writes "polydec: warning: ..." to stderr, and keeps it.
    void warn(const std::string& text);
    void warn(const std::vector<std::string>& texts) {
        for (const auto& text : texts)
            warn(text);
    }
};

/// Text that is made whole before it is printed.
class Text {
public:
    template <class... Values>
    void operator()(fmt::format_string<Values...> format, Values&&... values) {
        fmt::format_to(std::back_inserter(buffer_), format, std::forward<Values>(values)...);
    }
    std::string_view view() const { return {buffer_.data(), buffer_.size()}; }

private:
    fmt::memory_buffer buffer_;
};

/// A number that double precision may not have in the units of the file.
std::string in_digits(const std::optional<double>& number, int digits = 10);

/// What a command has found, to be told in one of two ways.
class Answer {
public:
    virtual ~Answer() = default;
    /// The members of the JSON object; warnings and timing are added behind them.
    virtual void write(JsonWriter& json) const = 0;
    virtual void write(Text& text) const = 0;

protected:
    Answer() = default;
    Answer(const Answer&) = default;
    Answer& operator=(const Answer&) = default;
};

/// How it is to be told.
struct TellOptions {
    bool json = false;
    bool timing = false;
};

/// Prints the answer, whole or not at all: one JSON object, or text. Throws SolverFailure,
/// whichever is asked for, if one of its numbers is NaN or infinite.
void tell(const Answer& answer, Log& log, const TellOptions& options);

} // namespace polydec::tools
