// SPDX-License-Identifier: MIT
#pragma once

#include "io/json_writer.h"

#include <fmt/format.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace polydec::tools {

/// What a stage of the work took in this process.
struct Stage {
    std::string name;
    double seconds = 0, cpu = 0;  ///< cpu: seconds of processors
    std::int64_t sent = 0;        ///< bytes to other processes, without solvers
    std::int64_t peak_memory = 0; ///< bytes, at the end of the stage
};

/// The stages, in the order they began. A stage lasts until the next one begins; a stage that
/// begins again resumes.
class Timing {
public:
    /// `sent` counts the bytes that this process has sent to others, if there are any.
    explicit Timing(std::function<std::int64_t()> sent = [] { return 0; });

    void begin(std::string_view stage);
    double end(); ///< the seconds of the stage that ends, or 0
    const std::vector<Stage>& stages() const { return stages_; }

private:
    using Clock = std::chrono::steady_clock;
    struct Counters {
        Clock::time_point time;
        double cpu;
        std::int64_t sent;
    };
    Counters counters() const;

    std::function<std::int64_t()> sent_;
    std::vector<Stage> stages_;
    std::optional<std::size_t> running_;
    Counters since_ = {};
};

/// Timing and warnings, part of every answer and of its JSON object.
struct Log {
    Timing timing = Timing();
    std::vector<std::string> warnings = {};
    std::filesystem::path mesh = {}; ///< the mesh file, once it is read

    /// Writes "polydec: warning: ..." to stderr, and records it.
    void warn(const std::string& text);
    void warn(const std::vector<std::string>& texts) {
        for (const auto& text : texts)
            warn(text);
    }
};

/// Text that is completed before it is printed.
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

/// A number in the units of the file; none if it exceeds double precision.
std::optional<double> in_range(const std::function<double()>& number);
std::string in_digits(const std::optional<double>& number, int digits = 10);

/// The result of a command, for output as JSON or text.
struct Answer {
    Answer(std::function<void(JsonWriter&)> members, std::function<void(Text&)> words)
        : json(std::move(members)), text(std::move(words)) {}

    /// By an object that writes both, and outlives this.
    template <class Written>
    Answer(const Written& of)
        : Answer([&of](JsonWriter& to) { of.write(to); }, [&of](Text& to) { of.write(to); }) {}

    std::function<void(JsonWriter&)> json; ///< its members; the caller appends warnings and timing
    std::function<void(Text&)> text;
};

/// The output format.
struct TellOptions {
    bool json = false;
    bool timing = false;
};

/// Prints the answer, whole or not at all: one JSON object, or text. Throws SolverFailure, in both
/// formats, if one of its numbers is NaN or infinite.
void tell(const Answer& answer, Log& log, const TellOptions& options);

} // namespace polydec::tools
