// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace polydec {

/// A file that need not be in memory as a whole: the name is for messages.
struct PartialFile {
    std::string name;
    std::int64_t size = 0; ///< in bytes

    /// The bytes from one place to another; less if there are no more.
    std::function<std::string(std::int64_t begin, std::int64_t end)> read;
};

} // namespace polydec
