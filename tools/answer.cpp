// SPDX-License-Identifier: MIT
#include "tools/answer.h"

#include "backends/linear/auto_solver.h"
#include "base/exponent.h"
#include "examples/paper/console.h"
#include "system/memory.h"
#include "tools/messages.h"

#include <algorithm>
#include <ctime>

namespace polydec::tools {

namespace {

void write_object(JsonWriter& json, const Answer& answer, const Log& log, bool timing) {
    json.object([&] {
        answer.json(json);
        json.member("warnings", log.warnings);
        if (!timing)
            return;
        json.object("timing", [&] {
            for (const Stage& stage : log.timing.stages())
                json.member(stage.name, stage.seconds);
        });
    });
}

void write_text(Text& text, const Answer& answer, const Log& log, bool timing) {
    answer.text(text);
    if (!timing)
        return;
    text("\nseconds\n");
    for (const Stage& stage : log.timing.stages())
        text("  {:<12} {:8.3f}\n", stage.name, stage.seconds);
}

} // namespace

Timing::Timing(std::function<std::int64_t()> sent) : sent_(std::move(sent)) {}

Timing::Counters Timing::counters() const {
    return {Clock::now(), static_cast<double>(std::clock()) / CLOCKS_PER_SEC, sent_()};
}

void Timing::begin(std::string_view stage) {
    end();
    const auto known = std::find_if(stages_.begin(), stages_.end(),
                                    [&](const Stage& each) { return each.name == stage; });
    running_ = static_cast<std::size_t>(known - stages_.begin());
    if (known == stages_.end())
        stages_.push_back({std::string(stage)});
    since_ = counters();
}

double Timing::end() {
    if (!running_)
        return 0;
    const auto [time, cpu, sent] = counters();
    Stage& stage = stages_[*std::exchange(running_, std::nullopt)];
    stage.cpu += cpu - since_.cpu;
    stage.sent += sent - since_.sent;
    stage.peak_memory = peak_memory();
    return stage.seconds += std::chrono::duration<double>(time - since_.time).count();
}

void Log::warn(const std::string& text) {
    warnings.push_back(told(text));
    console::tell(fmt::format("polydec: warning: {}\n", warnings.back()));
}

std::optional<double> in_range(const std::function<double()>& number) {
    try {
        return number();
    } catch (const OutOfRange&) {
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
