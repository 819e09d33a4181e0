// SPDX-License-Identifier: MIT
#include "system/memory.h"

#include "system/control_group.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <sys/resource.h>
#include <unistd.h>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace polydec {

namespace {

constexpr auto unlimited = std::numeric_limits<std::uint64_t>::max();

std::uint64_t of_machine() {
    const long pages = ::sysconf(_SC_PHYS_PAGES), size = ::sysconf(_SC_PAGESIZE);
    return pages > 0 && size > 0 ? static_cast<std::uint64_t>(pages) * size : unlimited;
}

std::uint64_t of_process(decltype(RLIMIT_AS) resource) {
    rlimit limit{};
    const bool known = ::getrlimit(resource, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
    return known ? limit.rlim_cur : unlimited;
}

std::atomic<std::uint64_t>& limit() {
    static std::atomic<std::uint64_t> bytes{machine_memory()};
    return bytes;
}

std::string size_text(double bytes) {
    return bytes >= 1e9 ? fmt::format("{:.3g} GB", bytes / 1e9)
                        : fmt::format("{:.3g} MB", bytes / 1e6);
}

} // namespace

std::uint64_t machine_memory() {
    return std::min(
        {of_machine(), of_process(RLIMIT_AS), of_process(RLIMIT_DATA), control_group_memory()});
}

std::int64_t peak_memory() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    constexpr std::int64_t kilo = 1024;
    return kilo * usage.ru_maxrss;
}

std::uint64_t memory_limit() {
    return limit();
}

void set_memory_limit(std::uint64_t bytes) {
    limit() = bytes;
}

std::string lack_of_memory(double bytes, std::string_view what) {
    const auto most = static_cast<double>(memory_limit());
    return bytes <= most ? ""
                         : fmt::format("{} needs about {} of memory, but the limit is {}", what,
                                       size_text(bytes), size_text(most));
}

void check_memory(double bytes, std::string_view what) {
    if (const auto lack = lack_of_memory(bytes, what); !lack.empty())
        throw IoError(lack + ": use fewer or simpler cells, or raise the limit (set_memory_limit)");
}

void keep_freed_memory() {
#ifdef __GLIBC__
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, -1);
#endif
}

} // namespace polydec
