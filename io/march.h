// SPDX-License-Identifier: MIT
#pragma once

#include "base/progress.h"
#include "solvers/time/run.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string_view>
#include <vector>

namespace polydec {

struct MarchOptions {
    /// Written after each time, once shown. A run that resumes anywhere also saves every minute and
    /// when it is stopped. Empty: no checkpoint.
    std::filesystem::path checkpoint = {};
    bool resume = true;                        ///< resumes from the checkpoint, if there is one
    std::function<void(const Run&)> show = {}; ///< called at each time, and at an event
    TimeListener progress = {};
    /// Called once in a long march, with a sentence about its steps and duration; see announcing.
    Progress announce = {};
    std::function<bool()> stop = {}; ///< called after each progress report; true: ends the march
};

/// A march through ascending times, one at a time.
class Frames {
public:
    /// Resumes from the checkpoint, if there is one. Throws InvalidInput if it belongs to another
    /// run or to other times, and if the run has no fingerprint (see Run); IoError if it cannot be
    /// read.
    Frames(Run& run, std::vector<double> times, MarchOptions options = {});

    /// The number of times already reached.
    std::size_t passed() const { return passed_; }

    /// Saves the current state and marches to the next time or the first event. Returns false at
    /// the end: after the last time, an event, or a stop. Throws like Run::march; IoError if the
    /// checkpoint cannot be written; the old one then stays.
    bool next();

    Arrival arrival() const { return arrival_; }

private:
    void go_on();
    void resume();
    void keep();
    void pass();
    void between(double time);

    Run& run_;
    std::vector<double> times_;
    MarchOptions options_;
    std::uint64_t problem_ = 0;
    std::size_t passed_ = 0;
    Fingerprint behind_; ///< of the times already reached
    Arrival arrival_ = Arrival::at_time;
    bool is_new_ = false; ///< the current state was shown but not saved
    std::chrono::steady_clock::time_point kept_ = std::chrono::steady_clock::now();
};

/// Marches through ascending times; shows and then saves the state at each. After an interruption,
/// the same run with the same times, or with more appended, resumes from the checkpoint, bit for
/// bit if the run can. A state that was shown but not saved is shown again. Throws like Frames.
Arrival march(Run& run, const std::vector<double>& times, const MarchOptions& options = {});

} // namespace polydec
