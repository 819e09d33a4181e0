// SPDX-License-Identifier: MIT
#include "system/temporary_name.h"

#include <fmt/format.h>

#include <atomic>
#include <unistd.h>

namespace polydec {

std::string temporary_name(std::string_view extension) {
    static std::atomic<unsigned> next{0};
    return fmt::format(".polydec-{}-{}{}", ::getpid(), next++, extension);
}

} // namespace polydec
