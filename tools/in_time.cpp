// SPDX-License-Identifier: MIT
#include "tools/in_time.h"

#include "base/errors.h"
#include "base/printable.h"
#include "dec/fields/flat_and_sharp.h"
#include "examples/paper/console.h"
#include "io/march.h"
#include "io/pages/series.h"
#include "io/source_file.h"
#include "tools/common.h"
#include "tools/messages.h"
#include "tools/outputs.h"
#include "tools/picture.h"
#include "tools/stop_signals.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <optional>

namespace polydec::tools {

namespace {

/// What is done, and the time that the rest will take, as often as somebody can read it.
class Remaining {
public:
    Remaining(std::string title, double first, double last)
        : title_(std::move(title)), first_(first), last_(last) {}

    void operator()(double done) {
        const auto now = Clock::now();
        if (now - told_ < std::chrono::milliseconds(200) || done == first_)
            return;
        told_ = now;
        const std::chrono::duration<double> spent = now - begin_;
        const double left = spent.count() * (last_ - done) / (done - first_);
        progress_(fmt::format("{}: {:.0f} %, {:.0f} s left", title_, 100.0 * done / last_,
                              std::ceil(left)));
    }

private:
    using Clock = std::chrono::steady_clock;
    std::string title_;
    double first_, last_;
    Clock::time_point begin_ = Clock::now(), told_ = begin_;
    ProgressLine progress_;
};

/// The steps after which frames are taken, beginning with 0 and ending with the last one.
Index step_of_frame(Index frame, Index frames, Index steps) {
    return static_cast<Index>(std::int64_t{frame} * steps / frames);
}

} // namespace

void add_time(CLI::App& command, TimeArguments& arguments, const std::string& own_step) {
    command.add_option("--until", arguments.until, "TIME\tend of the run")
        ->required()
        ->check(check_positive);
    command
        .add_option("--time-step", arguments.time_step,
                    fmt::format("TIME\tequal steps of at most TIME (default: {})", own_step))
        ->check(check_positive);
    command.add_option("--frames", arguments.frames, "N\tstates to write, besides the initial one")
        ->check(CLI::Range(1, 1'000'000));
    command.add_option("-o,--out", arguments.out,
                       "FILE\twrite .pvd series and folder, .html page that plays, .png or .svg");
    auto* checkpoint = command.add_option(
        "--checkpoint", arguments.checkpoint,
        "FILE\tkeep the state in this .checkpoint file: each frame, minute, Ctrl-C or SIGTERM");
    command
        .add_flag("--resume", arguments.resume,
                  "resume from the checkpoint if it exists; all other options must be the same")
        ->needs(checkpoint);
    add_page_options(command);
}

void check_time(const TimeArguments& arguments) {
    check_page_options(arguments.out);
    if (!arguments.out.empty())
        check_output_file(arguments.out, and_pages({".pvd"}));
    if (arguments.resume && is_page(arguments.out))
        throw InvalidInput(
            fmt::format("cannot resume with {}: a page is written from all frames at once; write a "
                        ".pvd file, then convert it with polydec view",
                        printable(arguments.out.string())),
            {.path = arguments.out});
    if (!arguments.checkpoint.empty())
        check_output_file(arguments.checkpoint, {".checkpoint"});
}

TimeSteps time_steps(const TimeArguments& arguments, double length) {
    return arguments.time_step > 0 ? polydec::time_steps(arguments.until, arguments.time_step)
                                   : polydec::time_steps(arguments.until, length, arguments.frames);
}

NamedForm flux_vectors(const std::string& name, const Discretization& mesh, const Cochain& flux,
                       const std::string& about) {
    try {
        return {name, Side::primal, vectors_at_vertices(mesh, flux, Proxy::flux), about};
    } catch (const InvalidInput&) {
        return {name, Side::dual, vectors_at_cells(mesh, flux, Proxy::flux), about};
    }
}

Ran march_to_end(Run& run, const March& march, const TimeArguments& arguments,
                 const Discretization& mesh, const Log& log) {
    const Index steps = march.steps.count, frames = std::min(arguments.frames, steps);
    std::vector<double> times;
    for (Index frame = 0; frame <= frames; ++frame)
        times.push_back(arguments.until * step_of_frame(frame, frames, steps) / steps);
    std::optional<StopSignals> signals;
    if (!arguments.checkpoint.empty())
        signals.emplace();
    std::optional<Remaining> remaining;
    Frames to_come(run, times,
                   {.checkpoint = arguments.checkpoint,
                    .resume = arguments.resume,
                    .progress = [&](double time) { (*remaining)(time); },
                    .announce =
                        [&](std::string_view sentence) {
                            ProgressLine(); // erases its line
                            console::tell(fmt::format("polydec: {}: {}\n", march.what,
                                                      told(std::string(sentence))));
                        },
                    .stop = [&] { return signals && signals->asked(); }});
    const double begin = run.time();
    remaining.emplace(march.what, begin, arguments.until);
    std::optional<Series> series;
    if (!arguments.out.empty())
        series.emplace(arguments.out, mesh, in_page(march.text, log),
                       std::vector(times.begin(), times.begin() + to_come.passed()),
                       run.fingerprint().value_or(polydec::Fingerprint()).value());
    while (computed_on(log.mesh, [&] { return to_come.next(); }))
        if (series)
            series->add(times[to_come.passed() - 1], march.shown(run));
    if (signals && signals->asked())
        signals->end();
    if (series)
        series->close();
    return {march.steps, static_cast<Index>(std::lround(begin / march.steps.length)), frames + 1};
}

std::string in_words(const std::optional<double>& part) {
    return part ? fmt::format(", {:.12g} of that at the beginning", *part) : std::string();
}

void Ran::write(JsonWriter& json) const {
    json.member("time", steps.length * steps.count);
    json.member("time_step", steps.length);
    json.member("steps", steps.count);
    json.member("frames", frames);
    json.member("resumed_at", resumed_at);
}

std::string Ran::in_words() const {
    auto text = fmt::format("{} step{} of {:.6g} to the time {:.10g}", steps.count,
                            steps.count == 1 ? "" : "s", steps.length, steps.length * steps.count);
    if (resumed_at > 0)
        text += fmt::format(", resumed after step {}", resumed_at);
    return text;
}

} // namespace polydec::tools
