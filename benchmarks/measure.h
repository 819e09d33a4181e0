// SPDX-License-Identifier: MIT
#pragma once

#include "benchmarks/bytes.h"

#include <benchmark/benchmark.h>
#include <chrono>
#include <string>
#include <vector>

namespace polydec::benchmarks {

/// What a row works on.
struct Amount {
    double cells = 0;    ///< simplices of top dimension, or unknowns
    double bytes_in = 0; ///< to be read at least once
};

/// The middle one, or the mean of the two in the middle; of at least one number.
double median(std::vector<double> values);

/// Times and memory of one piece of work, round by round.
class Samples {
public:
    void begin();
    void end();

    double last() const { return seconds_.back(); }
    double minimum() const;
    double median() const;

    /// Counters min_s and median_s, after the prefix.
    void report_times(benchmark::State& state, const std::string& prefix = "") const;

    /// Counters cells; result_B and peak_B: allocated at the end of a round and at most in it,
    /// beyond the input, for each cell.
    void report_memory(benchmark::State& state, double cells) const;

    const std::vector<double>& seconds() const { return seconds_; }

private:
    std::chrono::steady_clock::time_point begin_;
    double live_before_ = 0, result_ = 0, peak_ = 0;
    std::vector<double> seconds_;
};

/// Counters bound_s: the time to read and write that many bytes at copy bandwidth; over_bound: the
/// shortest time over it.
void report_bound(benchmark::State& state, const Samples& samples, double bytes);

/// Counters ratio and rival_min_s, rival_median_s: ours over theirs, the median over the rounds.
void report_rival(benchmark::State& state, const Samples& ours, const Samples& theirs);

/// How far our answer is from theirs: the norm of the difference over that of theirs.
template <typename Matrix>
double difference(const Eigen::EigenBase<Matrix>& ours, const Eigen::EigenBase<Matrix>& theirs) {
    return (ours.derived() - theirs.derived()).norm() / theirs.derived().norm();
}
inline double difference(const Cochain& ours, const Vector& theirs) {
    return difference(ours.values, theirs);
}

/// Whether they do the same work; if not the row becomes an error.
bool agree(benchmark::State& state, double difference);

/// Rounds of work(prepare()), only work being timed; a first one, which touches the memory, is not
/// counted. Whatever work returns is freed outside of the time.
template <typename Prepare, typename Work>
void measure_prepared(benchmark::State& state, const Amount& amount, Prepare prepare, Work work) {
    const double bytes_out = bytes(work(prepare()));
    Samples samples;
    for ([[maybe_unused]] auto _ : state) {
        auto input = prepare();
        samples.begin();
        auto result = work(std::move(input));
        benchmark::DoNotOptimize(&result);
        samples.end();
        state.SetIterationTime(samples.last());
    }
    samples.report_times(state);
    samples.report_memory(state, amount.cells);
    report_bound(state, samples, amount.bytes_in + bytes_out);
}

/// The same for work that needs nothing of its own to begin with.
template <typename Work>
void measure(benchmark::State& state, const Amount& amount, Work work) {
    measure_prepared(
        state, amount, [] { return 0; }, [&](int) { return work(); });
}

/// Rounds of ours and theirs in turn, after a first one of each that is not counted, but whose
/// answers are compared.
template <typename Ours, typename Theirs>
void compare(benchmark::State& state, const Amount& amount, Ours ours, Theirs theirs) {
    double bytes_out = 0;
    {
        const auto answer = ours();
        if (!agree(state, difference(answer, theirs())))
            return;
        bytes_out = bytes(answer);
    }
    Samples our_samples, their_samples;
    for ([[maybe_unused]] auto _ : state) {
        {
            our_samples.begin();
            auto result = ours();
            benchmark::DoNotOptimize(&result);
            our_samples.end();
        }
        {
            their_samples.begin();
            auto result = theirs();
            benchmark::DoNotOptimize(&result);
            their_samples.end();
        }
        state.SetIterationTime(our_samples.last());
    }
    our_samples.report_times(state);
    our_samples.report_memory(state, amount.cells);
    report_bound(state, our_samples, amount.bytes_in + bytes_out);
    report_rival(state, our_samples, their_samples);
}

} // namespace polydec::benchmarks
