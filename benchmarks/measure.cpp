// SPDX-License-Identifier: MIT
#include "benchmarks/measure.h"

#include "benchmarks/bandwidth.h"
#include "benchmarks/memory.h"

#include <algorithm>

namespace polydec::benchmarks {

namespace {

constexpr double largest_difference = 1e-6;

} // namespace

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    const std::size_t half = values.size() / 2;
    return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

bool agree(benchmark::State& state, double difference) {
    if (difference <= largest_difference)
        return true;
    state.SkipWithError(
        ("our answer is not theirs: the relative difference is " + std::to_string(difference))
            .c_str());
    return false;
}

void Samples::begin() {
    forget_peak();
    live_before_ = live_bytes();
    begin_ = std::chrono::steady_clock::now();
}

void Samples::end() {
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin_;
    seconds_.push_back(time.count());
    result_ = live_bytes() - live_before_;
    peak_ = peak_bytes() - live_before_;
}

double Samples::minimum() const {
    return *std::min_element(seconds_.begin(), seconds_.end());
}

double Samples::median() const {
    return benchmarks::median(seconds_);
}

void Samples::report_times(benchmark::State& state, const std::string& prefix) const {
    state.counters[prefix + "min_s"] = minimum();
    state.counters[prefix + "median_s"] = median();
}

void Samples::report_memory(benchmark::State& state, double cells) const {
    state.counters["cells"] = cells;
    if (!counts_memory())
        return;
    state.counters["result_B"] = result_ / cells;
    state.counters["peak_B"] = peak_ / cells;
}

void report_bound(benchmark::State& state, const Samples& samples, double bytes) {
    const double bound = bytes / copy_bandwidth();
    state.counters["bound_s"] = bound;
    state.counters["over_bound"] = samples.minimum() / bound;
}

void report_rival(benchmark::State& state, const Samples& ours, const Samples& theirs) {
    theirs.report_times(state, "rival_");
    std::vector<double> ratios;
    for (std::size_t i = 0; i < ours.seconds().size(); ++i)
        ratios.push_back(ours.seconds()[i] / theirs.seconds()[i]);
    state.counters["ratio"] = median(ratios);
}

} // namespace polydec::benchmarks
