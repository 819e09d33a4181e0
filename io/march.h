// SPDX-License-Identifier: MIT
#pragma once

#include "solvers/time/run.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <vector>

namespace polydec {

struct MarchOptions {
    /// Kept after each time, once shown; of a run that resumes anywhere also every minute and when
    /// it is stopped. Empty: none.
    std::filesystem::path checkpoint = {};
    bool resume = true;                        ///< goes on from the checkpoint, if there is one
    std::function<void(const Run&)> show = {}; ///< called at each time, and at an event
    TimeListener progress = {};
    std::function<bool()> stop = {}; ///< asked as often as progress is told; true: ends the march
};

/// A march to ascending times, from one to the next.
class Frames {
public:
    /// Resumes from the checkpoint, if there is one. Throws InvalidInput if it belongs to another
    /// run or to other times, and if the run has no fingerprint (see Run); IoError if it cannot be
    /// read.
    Frames(Run& run, std::vector<double> times, MarchOptions options = {});

    /// How many of the times are behind.
    std::size_t passed() const { return passed_; }

    /// Keeps what is there and marches to the next time or the first event; false where there is
    /// none more: behind the last time, an event, or a stop. Throws like Run::march; IoError if
    /// the checkpoint cannot be written, which then stays as it was.
    bool next();

    Arrival arrival() const { return arrival_; }

private:
    void go_on();
    void keep();
    void between(double time);

    Run& run_;
    std::vector<double> times_;
    MarchOptions options_;
    std::uint64_t problem_ = 0;
    std::size_t passed_ = 0;
    Arrival arrival_ = Arrival::at_time;
    bool is_new_ = false; ///< what is there, and shown, is not kept yet
    std::chrono::steady_clock::time_point kept_ = std::chrono::steady_clock::now();
};

/// Marches to each of these ascending times, shows what is there and then keeps it. If it is killed
/// and started again with the same run and times, or with more behind them, it goes on from the
/// checkpoint, to the same bits if the run can; what was killed between showing and keeping is
/// shown again. Throws like Frames.
Arrival march(Run& run, const std::vector<double>& times, const MarchOptions& options = {});

} // namespace polydec
