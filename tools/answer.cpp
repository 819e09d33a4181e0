// SPDX-License-Identifier: MIT
#include "tools/answer.h"

#include "backends/linear/auto_solver.h"
#include "examples/paper/console.h"
#include "tools/messages.h"

#include <algorithm>

namespace polydec::tools {

namespace {

void write_object(JsonWriter& json, const Answer& answer, const Log& log, bool timing) {
    json.object([&] {
        answer.json(json);
        json.member("warnings", log.warnings);
        if (!timing)
            return;
        json.object("timing", [&] {
            for (const auto& [stage, seconds] : log.timing.seconds())
                json.member(stage, seconds);
        });
    });
}

void write_text(Text& text, const Answer& answer, const Log& log, bool timing) {
    answer.text(text);
    if (!timing)
        return;
    text("\nseconds\n");
    for (const auto& [stage, seconds] : log.timing.seconds())
        text("  {:<12} {:8.3f}\n", stage, seconds);
}

} // namespace

void Timing::begin(std::string_view stage) {
    end();
    const auto it = std::find_if(seconds_.begin(), seconds_.end(),
                                 [&](const auto& entry) { return entry.first == stage; });
    running_ = static_cast<std::size_t>(it - seconds_.begin());
    if (it == seconds_.end())
        seconds_.emplace_back(stage, 0.0);
    since_ = Clock::now();
}

double Timing::end() {
    if (!running_)
        return 0;
    auto& [stage, seconds] = seconds_[*std::exchange(running_, std::nullopt)];
    return seconds += std::chrono::duration<double>(Clock::now() - since_).count();
}

void Log::warn(const std::string& text) {
    warnings.push_back(told(text));
    console::tell(fmt::format("polydec: warning: {}\n", warnings.back()));
}

std::optional<double> in_range(const std::function<double()>& number) {
    try {
        return number();
    } catch (const InvalidInput&) {
        return std::nullopt;
    }
}

std::string in_digits(const std::optional<double>& number, int digits) {
    return number ? fmt::format("{:.{}g}", *number, digits) : "out of range";
}

void tell(const Answer& answer, Log& log, const TellOptions& options) {
    log.timing.end();
    if (const auto missed = take_missed_engines(); !missed.empty())
        log.warn(missed);
    // made in any case, since it is there that numbers which are none are found
    JsonWriter json;
    write_object(json, answer, log, options.timing);
    Text text;
    if (options.json)
        text("{}\n", json.view());
    else
        write_text(text, answer, log, options.timing);
    console::write(text.view());
}

} // namespace polydec::tools
