// SPDX-License-Identifier: MIT
#include "tools/in_time.h"

#include "base/errors.h"
#include "base/printable.h"
#include "io/pages/series.h"
#include "io/source_file.h"
#include "tools/common.h"
#include "tools/options.h"
#include "tools/outputs.h"
#include "tools/stop_signals.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <system_error>

namespace polydec::tools {

namespace {

/// Steps done, and the time that the others will take, as often as somebody can read it.
class Remaining {
public:
    Remaining(std::string title, Index first, Index last)
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
    Index first_, last_;
    Clock::time_point begin_ = Clock::now(), told_ = begin_;
    Progress progress_;
};

/// The steps after which frames are taken, beginning with 0 and ending with the last one.
Index step_of_frame(Index frame, Index frames, Index steps) {
    return static_cast<Index>(std::int64_t{frame} * steps / frames);
}

void check_numbers(const std::vector<Vector>& state, Index step) {
    for (const Vector& values : state)
        if (!values.allFinite())
            throw SolverFailure(fmt::format("after step {} values are no finite numbers: take "
                                            "shorter steps, or look at the data",
                                            step));
}

/// Options that change nothing of the numbers: where answers go and how they are told, how far and
/// in whose memory, and the mesh, whose content is known.
constexpr std::array<std::string_view, 8> without_effect{"-h,--help",    "MESH",        "-o,--out",
                                                         "--checkpoint", "--resume",    "--json",
                                                         "--timing",     "--max-memory"};

/// Of all that makes the numbers: what files hold, not what they are called.
Fingerprint problem_of(const March& march, const TimeArguments& arguments, Index frames) {
    auto result = march.problem;
    result.add(march.what).add(static_cast<std::uint64_t>(march.steps.count));
    result.add(march.steps.length).add(static_cast<std::uint64_t>(frames));
    for (const CLI::Option* option : arguments.command->get_options()) {
        const std::string name = option->get_name(false, true);
        if (option->count() == 0 ||
            std::find(without_effect.begin(), without_effect.end(), name) != without_effect.end())
            continue;
        result.add(name);
        for (const std::string& given : option->results()) {
            std::error_code error;
            const bool is_file = std::filesystem::is_regular_file(given, error);
            result.add(is_file ? read_source_file(given).text : given);
        }
    }
    return result;
}

/// Keeps the states of a march: at frames, when the last one is long ago, and before the program
/// ends by a signal.
class Keeper {
public:
    Keeper(const std::filesystem::path& path, std::uint64_t problem)
        : path_(path), problem_(problem) {
        if (!path.empty())
            signals_.emplace();
    }

    void operator()(const March& march, Index step, double time, bool at_frame) {
        if (path_.empty())
            return;
        const auto now = Clock::now();
        const bool ends = signals_->asked();
        if (at_frame || ends || now - kept_ > longest) {
            check_numbers(march.state, step);
            write_checkpoint(path_,
                             {problem_, static_cast<std::uint64_t>(step), time, march.state});
            kept_ = now;
        }
        if (ends)
            signals_->end();
    }

    /// Ends within a step: what was kept last stays.
    void within() const {
        if (signals_ && signals_->asked())
            signals_->end();
    }

private:
    using Clock = std::chrono::steady_clock;
    static constexpr std::chrono::seconds longest{60};

    std::filesystem::path path_;
    std::uint64_t problem_;
    std::optional<StopSignals> signals_;
    Clock::time_point kept_ = Clock::now();
};

/// Takes the state of a checkpoint, if there is one to go on from; the step it was made after.
Index resume(March& march, const TimeArguments& arguments, std::uint64_t problem) {
    if (!arguments.resume || !std::filesystem::exists(arguments.checkpoint))
        return 0;
    auto checkpoint = read_checkpoint(arguments.checkpoint, problem);
    march.state = std::move(checkpoint.state);
    return static_cast<Index>(checkpoint.step);
}

} // namespace

void add_time(CLI::App& command, TimeArguments& arguments, const std::string& own_step) {
    arguments.command = &command;
    command.add_option("--until", arguments.until, "the time at the end")
        ->required()
        ->check(CLI::PositiveNumber);
    command
        .add_option("--time-step", arguments.time_step,
                    fmt::format("how long a step is at most (default: {});\nsteps are made equal",
                                own_step))
        ->check(CLI::PositiveNumber);
    command
        .add_option("--frames", arguments.frames,
                    "how many times are written, equally far apart, and the beginning")
        ->check(CLI::Range(1, 1'000'000))
        ->capture_default_str();
    command.add_option("-o,--out", arguments.out,
                       "write a series to this .pvd file, with a folder beside it, or a\n"
                       ".html page that plays");
    auto* checkpoint = command.add_option("--checkpoint", arguments.checkpoint,
                                          "keep the state in this .checkpoint file: at each frame, "
                                          "every\nminute, and when Ctrl-C or SIGTERM ends the run");
    command
        .add_flag("--resume", arguments.resume,
                  "go on from the checkpoint, if it is there; all else must be as\nit was")
        ->needs(checkpoint);
}

void check_time(const TimeArguments& arguments, Paths inputs) {
    if (!arguments.out.empty())
        check_output_file(arguments.out, {".pvd", ".html"}, inputs);
    if (arguments.resume && lower_extension(arguments.out) == ".html")
        throw InvalidInput(fmt::format("cannot go on with {}: a page is made of all its steps at "
                                       "once; write a .pvd file, and make a page of it at the end "
                                       "by polydec view",
                                       printable(arguments.out.string())),
                           {.path = arguments.out});
    if (!arguments.checkpoint.empty())
        check_output_file(arguments.checkpoint, {".checkpoint"}, inputs);
}

TimeSteps time_steps(const TimeArguments& arguments, double length) {
    constexpr double most = 1e9, rounding = 1e-9;
    const double multiple = arguments.time_step > 0 ? 1 : arguments.frames;
    if (arguments.time_step > 0)
        length = arguments.time_step;
    const double count =
        multiple * std::max(1.0, std::ceil(arguments.until / length / multiple - rounding));
    if (!(count <= most))
        throw InvalidInput(fmt::format("{:.3g} steps of {:.3g} are asked for: expected at most "
                                       "{:.0g}",
                                       count, length, most));
    return {static_cast<Index>(count), arguments.until / count};
}

Ran run(March& march, const TimeArguments& arguments, const Discretization& mesh) {
    const Index steps = march.steps.count;
    const auto time_after = [&](Index step) { return arguments.until * step / steps; };
    const Index frames = std::min(arguments.frames, steps);
    const std::uint64_t problem = problem_of(march, arguments, frames).value();
    const Index first = resume(march, arguments, problem);
    std::vector<double> times; // of frames that an earlier run has written
    Index frame = 0;
    for (; first > 0 && step_of_frame(frame, frames, steps) <= first; ++frame)
        times.push_back(time_after(step_of_frame(frame, frames, steps)));
    std::optional<Series> series;
    if (!arguments.out.empty())
        series.emplace(arguments.out, mesh, march.text, times, problem);
    Remaining remaining(march.what, first, steps);
    Keeper keep(arguments.checkpoint, problem);
    for (Index step = first;; ++step) {
        const bool at_frame = frame <= frames && step == step_of_frame(frame, frames, steps);
        if (at_frame) {
            check_numbers(march.state, step);
            if (series)
                series->add(time_after(step), march.shown(march.state));
            ++frame;
        }
        keep(march, step, time_after(step), at_frame);
        if (step == steps)
            break;
        march.within = [&, step](double part) {
            keep.within();
            remaining(step + part);
        };
        march.step(march.state);
        remaining(step + 1);
    }
    if (series)
        series->close();
    return {first, frames + 1};
}

std::optional<double> in_range(const std::function<double()>& number) {
    try {
        return number();
    } catch (const InvalidInput&) {
        return std::nullopt;
    }
}

std::optional<double> part_of(double now, double before) {
    return before > 0 ? std::optional(now / before) : std::nullopt;
}

std::string in_words(const std::optional<double>& part) {
    return part ? fmt::format(", {:.12g} of that at the beginning", *part) : std::string();
}

void write_time(JsonWriter& json, const TimeSteps& steps, const Ran& ran) {
    json.member("time", steps.length * steps.count);
    json.member("time_step", steps.length);
    json.member("steps", steps.count);
    json.member("frames", ran.frames);
    json.member("resumed_at", ran.resumed_at);
}

std::string in_words(const TimeSteps& steps, const Ran& ran) {
    auto text = fmt::format("{} step{} of {:.6g} to the time {:.10g}", steps.count,
                            steps.count == 1 ? "" : "s", steps.length, steps.length * steps.count);
    if (ran.resumed_at > 0)
        text += fmt::format(", gone on with after step {}", ran.resumed_at);
    return text;
}

} // namespace polydec::tools
