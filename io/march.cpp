// SPDX-License-Identifier: MIT
#include "io/march.h"

#include "base/errors.h"
#include "base/printable.h"
#include "io/checkpoint.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace polydec {

namespace {

constexpr std::chrono::seconds longest{60}; // between checkpoints

struct Stopped {};

/// The bits of a fingerprint that a number holds.
double number_of(const Fingerprint& of) {
    return static_cast<double>(of.value() >> (64 - std::numeric_limits<double>::digits));
}

} // namespace

Frames::Frames(Run& run, std::vector<double> times, MarchOptions options)
    : run_(run), times_(std::move(times)), options_(std::move(options)) {
    if (!options_.checkpoint.empty())
        go_on();
    options_.progress = announcing(run_, times_, options_.announce, options_.progress);
}

void Frames::go_on() {
    const auto problem = run_.fingerprint();
    if (!problem)
        throw InvalidInput("a checkpoint cannot compare the functions of this run: give the run a "
                           "label that names the functions and their parameters");
    problem_ = problem->value();
    if (options_.resume && std::filesystem::exists(options_.checkpoint))
        resume();
}

/// Behind the state of a run are two numbers of the march: 1 if an event has ended it, and the
/// fingerprint of the times that are behind.
void Frames::keep() {
    Checkpoint now{problem_, passed_, run_.time(), run_.state()};
    now.state.push_back(Vector{{arrival_ == Arrival::at_event ? 1.0 : 0.0, number_of(behind_)}});
    write_checkpoint(options_.checkpoint, now);
    kept_ = std::chrono::steady_clock::now();
    is_new_ = false;
}

void Frames::resume() {
    Checkpoint last = read_checkpoint(options_.checkpoint, problem_);
    const auto refuse = [&](const char* why) {
        throw InvalidInput(
            fmt::format("{} cannot be resumed: {}", printable(options_.checkpoint.string()), why),
            {.path = options_.checkpoint});
    };
    if (last.state.empty() || last.state.back().size() != 2)
        refuse("it is not the checkpoint of a march");
    const Vector of_march = last.state.back();
    while (passed_ < std::min<std::size_t>(last.step, times_.size()))
        pass();
    if (passed_ != last.step || number_of(behind_) != of_march[1])
        refuse("it belongs to a march with another list of times; start a new run, or give the "
               "same times");
    last.state.pop_back();
    run_.resume(last.time, last.state);
    arrival_ = of_march[0] != 0 ? Arrival::at_event : Arrival::at_time;
}

void Frames::pass() {
    behind_.add(times_[passed_]);
    ++passed_;
}

void Frames::between(double time) {
    if (options_.progress)
        options_.progress(time);
    if (options_.stop && options_.stop())
        throw Stopped();
    if (!options_.checkpoint.empty() && run_.resumes_anywhere() &&
        std::chrono::steady_clock::now() - kept_ > longest)
        keep();
}

bool Frames::next() {
    if (is_new_ && !options_.checkpoint.empty())
        keep();
    if (passed_ == times_.size() || arrival_ == Arrival::at_event ||
        (options_.stop && options_.stop()))
        return false;
    try {
        arrival_ = run_.march(times_[passed_], [this](double time) { between(time); });
    } catch (const Stopped&) {
        if (!options_.checkpoint.empty() && run_.resumes_anywhere())
            keep();
        return false;
    }
    pass();
    is_new_ = true;
    return true;
}

Arrival march(Run& run, const std::vector<double>& times, const MarchOptions& options) {
    Frames frames(run, times, options);
    while (frames.next())
        if (options.show)
            options.show(run);
    return frames.arrival();
}

} // namespace polydec
