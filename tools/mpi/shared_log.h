// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/ranks.h"
#include "tools/answer.h"

namespace polydec::tools {

/// What a rank took for a stage, or the busiest rank.
struct StageEffort {
    std::string stage;
    double cpu = 0;               ///< seconds
    std::int64_t sent = 0;        ///< bytes to other ranks, without those of solvers
    std::int64_t peak_memory = 0; ///< bytes, until the stage ended
};

/// What a process has held at its peak so far; bytes.
std::int64_t peak_memory();

/// A log that knows besides what each stage takes this rank.
class SharedLog : public Log {
public:
    explicit SharedLog(const Ranks& ranks) : ranks_(ranks) {}

    /// A stage lasts until the next one begins, and goes on if it begins again.
    void begin(std::string_view stage);
    void end();

    /// Collective: the most that any rank took for each stage so far, which are the same on all.
    std::vector<StageEffort> busiest() const;

private:
    struct Counters {
        double cpu;
        std::int64_t sent;
    };
    Counters counters() const;

    Ranks ranks_;
    std::vector<StageEffort> stages_;
    std::optional<std::size_t> running_;
    Counters since_ = {0, 0};
};

} // namespace polydec::tools
