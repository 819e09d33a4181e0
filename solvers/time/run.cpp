// SPDX-License-Identifier: MIT
#include "solvers/time/run.h"

#include "system/memory.h"

#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cmath>
#include <utility>

namespace polydec {

namespace {

using Clock = std::chrono::steady_clock;

std::string with_commas(std::int64_t count) {
    return count < 1000 ? fmt::format("{}", count)
                        : fmt::format("{},{:03}", with_commas(count / 1000), count % 1000);
}

/// In the largest unit that fits at least twice: 90 min, but 2 h.
std::string duration_in_words(double seconds) {
    struct Unit {
        double seconds;
        const char* name;
    };
    constexpr std::array units{Unit{365.25 * 86400, "years"}, Unit{86400, "days"}, Unit{3600, "h"},
                               Unit{60, "min"}};
    constexpr double most = 1e15; // in digits
    for (const Unit& unit : units)
        if (const double count = seconds / unit.seconds; count > most)
            return fmt::format("{:.2g} {}", count, unit.name);
        else if (count >= 2)
            return fmt::format("{} {}", with_commas(std::llround(count)), unit.name);
    return fmt::format("{:.0f} s", seconds);
}

std::string in_words(const StepPlan& plan, double seconds) {
    const std::string steps =
        plan.count ? fmt::format("{} steps of {:.3g}", with_commas(*plan.count), plan.length)
                   : "adaptive steps";
    const double memory = static_cast<double>(peak_memory());
    return fmt::format("{}, limited by {}; about {}{}, {:.2g} {} of memory; {}", steps, plan.limit,
                       duration_in_words(seconds), plan.count ? "" : " at the pace so far",
                       memory / (memory < 1e9 ? 1e6 : 1e9), memory < 1e9 ? "MB" : "GB",
                       plan.advice);
}

} // namespace

TimeListener announcing(const Run& run, const std::vector<double>& times, Progress announce,
                        TimeListener progress) {
    struct Measured {
        double time;
        Clock::time_point at;
    };
    return [=, plan = run.plan(times), begin = run.time(), end = times.empty() ? 0 : times.back(),
            first = std::optional<Measured>()](double time) mutable {
        // a first step may also factorize, and first adaptive steps are short
        const double measured = plan.count ? 1 : 5, long_time = 10; // seconds
        const auto now = Clock::now();
        if (!first && time > begin)
            first = {time, now};
        if (announce && first && time > first->time) {
            const std::chrono::duration<double> spent = now - first->at;
            const double pace = spent.count() / (time - first->time);
            if (spent.count() > measured && pace * (end - time) > long_time)
                std::exchange(announce, nullptr)(in_words(plan, pace * (end - begin)));
        }
        if (progress)
            progress(time);
    };
}

} // namespace polydec
