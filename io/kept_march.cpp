// SPDX-License-Identifier: MIT
#include "io/kept_march.h"

#include "base/errors.h"
#include "io/checkpoint.h"

namespace polydec {

namespace {

/// Of a march: the state of the run, and behind it 1 if an event ended it, else 0.
Checkpoint kept(const Evolution& run, std::uint64_t problem, std::uint64_t step, Arrival arrival) {
    Checkpoint result{problem, step, run.time(), run.state()};
    result.state.push_back(Vector::Constant(1, arrival == Arrival::at_event ? 1 : 0));
    return result;
}

Arrival go_on(Evolution& run, Checkpoint kept) {
    if (kept.state.empty() || kept.state.back().size() != 1)
        throw InvalidInput("the checkpoint is none of a march that kept_march keeps");
    const bool had_ended = kept.state.back()[0] != 0;
    kept.state.pop_back();
    run.resume(kept.time, kept.state);
    return had_ended ? Arrival::at_event : Arrival::at_time;
}

} // namespace

Arrival kept_march(Evolution& run, const std::vector<double>& times,
                   const std::filesystem::path& checkpoint, std::uint64_t problem,
                   const std::function<void(const Evolution&)>& show) {
    Arrival arrival = Arrival::at_time;
    std::uint64_t step = 0;
    if (std::filesystem::exists(checkpoint)) {
        const Checkpoint last = read_checkpoint(checkpoint, problem);
        step = last.step;
        arrival = go_on(run, last);
    }
    for (; step < times.size() && arrival == Arrival::at_time; ++step) {
        arrival = run.march(times[step]);
        if (show)
            show(run);
        write_checkpoint(checkpoint, kept(run, problem, step + 1, arrival));
    }
    return arrival;
}

} // namespace polydec
