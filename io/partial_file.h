// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>

namespace polydec {

/// A file that need not fit in memory; the name is for messages.
struct PartialFile {
    std::string name;
    std::int64_t size = 0; ///< in bytes

    /// The bytes in [begin, end); fewer at the end of the file.
    std::function<std::string(std::int64_t begin, std::int64_t end)> read;
};

} // namespace polydec
