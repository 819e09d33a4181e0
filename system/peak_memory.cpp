// SPDX-License-Identifier: MIT
#include "system/peak_memory.h"

#include <sys/resource.h>

namespace polydec {

std::int64_t peak_memory() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    constexpr std::int64_t kilo = 1024;
    return kilo * usage.ru_maxrss;
}

} // namespace polydec
