// SPDX-License-Identifier: MIT
#include "benchmarks/bandwidth.h"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <chrono>
#include <cstddef>
#include <cstring>
#include <unistd.h>
#include <vector>

namespace polydec::benchmarks {

namespace {

bool is_rough = false;

std::size_t largest_cache() {
#ifdef _SC_LEVEL3_CACHE_SIZE
    const long size = sysconf(_SC_LEVEL3_CACHE_SIZE);
    return size > 0 ? static_cast<std::size_t>(size) : 0;
#else
    return 0;
#endif
}

double measured_bandwidth() {
    // Machines in the cloud name the cache that all their guests share, so there is an upper limit.
    constexpr std::size_t mega = std::size_t{1} << 20;
    const std::size_t size = is_rough ? mega : std::clamp(largest_cache(), 128 * mega, 512 * mega);
    std::vector<char> from(size, 1), to(size, 2);
    double best = 0;
    for (int round = 0; round < 7; ++round) {
        const auto begin = std::chrono::steady_clock::now();
        std::memcpy(to.data(), from.data(), size);
        benchmark::DoNotOptimize(to.data());
        benchmark::ClobberMemory();
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
        best = std::max(best, 2.0 * static_cast<double>(size) / time.count());
    }
    return best;
}

} // namespace

double copy_bandwidth() {
    static const double value = measured_bandwidth();
    return value;
}

void measure_bandwidth_roughly() {
    is_rough = true;
}

} // namespace polydec::benchmarks
