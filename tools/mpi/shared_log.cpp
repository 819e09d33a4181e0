// SPDX-License-Identifier: MIT
#include "tools/mpi/shared_log.h"

#include "system/memory.h"

#include <algorithm>
#include <ctime>

namespace polydec::tools {

SharedLog::Counters SharedLog::counters() const {
    return {static_cast<double>(std::clock()) / CLOCKS_PER_SEC, ranks_.bytes_sent()};
}

void SharedLog::begin(std::string_view stage) {
    end();
    timing.begin(stage);
    const auto known = std::find_if(stages_.begin(), stages_.end(), [&](const StageEffort& effort) {
        return effort.stage == stage;
    });
    running_ = static_cast<std::size_t>(known - stages_.begin());
    if (known == stages_.end())
        stages_.push_back({std::string(stage)});
    since_ = counters();
}

void SharedLog::end() {
    timing.end();
    if (!running_)
        return;
    const auto [cpu, sent] = counters();
    StageEffort& effort = stages_[*running_];
    effort.cpu += cpu - since_.cpu;
    effort.sent += sent - since_.sent;
    effort.peak_memory = peak_memory();
    running_.reset();
}

std::vector<StageEffort> SharedLog::busiest() const {
    std::vector<StageEffort> most = stages_;
    for (StageEffort& effort : most) {
        effort.cpu = ranks_.largest(effort.cpu);
        effort.sent = ranks_.largest(effort.sent);
        effort.peak_memory = ranks_.largest(effort.peak_memory);
    }
    return most;
}

} // namespace polydec::tools
