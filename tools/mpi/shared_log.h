// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/ranks.h"
#include "tools/answer.h"

namespace polydec::tools {

/// The effort of a rank, or of the busiest rank, for a stage.
struct StageEffort {
    std::string stage;
    double cpu = 0;               ///< seconds
    std::int64_t sent = 0;        ///< bytes to other ranks, without solvers
    std::int64_t peak_memory = 0; ///< bytes, at the end of the stage
};

/// A log that also records this rank's effort per stage.
class SharedLog : public Log {
public:
    explicit SharedLog(const Ranks& ranks) : ranks_(ranks) {}

    /// A stage lasts until the next one begins, and resumes if it begins again.
    void begin(std::string_view stage);
    void end();

    /// Collective: the largest effort of any rank for each stage so far, identical on all ranks.
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
