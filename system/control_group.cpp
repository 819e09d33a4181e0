// SPDX-License-Identifier: MIT
#include "system/control_group.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <string>
#include <string_view>

namespace polydec {

namespace {

using Path = std::filesystem::path;

/// A file that holds a number of bytes, or a word where there is no limit.
std::uint64_t bytes_in(const Path& path) {
    std::ifstream file(path);
    std::uint64_t bytes = 0;
    return file >> bytes ? bytes : std::numeric_limits<std::uint64_t>::max();
}

/// The least limit of a group and those around it. In a container the group may not be below the
/// mount; then those that are there count.
std::uint64_t least_around(const Path& root, std::string_view group, const char* limit) {
    Path inner = Path(group).lexically_normal().relative_path();
    std::uint64_t least = bytes_in(root / limit);
    for (; !inner.empty(); inner = inner.parent_path())
        least = std::min(least, bytes_in(root / inner / limit));
    return least;
}

/// Whether a list with commas has the word "memory".
bool has_memory(std::string_view controllers) {
    while (!controllers.empty()) {
        const auto comma = std::min(controllers.find(','), controllers.size());
        if (controllers.substr(0, comma) == "memory")
            return true;
        controllers.remove_prefix(std::min(comma + 1, controllers.size()));
    }
    return false;
}

} // namespace

std::uint64_t control_group_memory(const Path& groups, const Path& mount) {
    constexpr const char* limit_of_first = "memory.limit_in_bytes";
    constexpr const char* limit_of_second = "memory.max";
    const Path first = mount / "memory";
    std::uint64_t least = std::min(bytes_in(mount / limit_of_second), //
                                   bytes_in(first / limit_of_first));
    std::ifstream file(groups);
    for (std::string line; std::getline(file, line);) {
        // number:controllers:group, where the second version has no controllers
        const auto begin = line.find(':'), end = line.find(':', begin + 1);
        if (begin == std::string::npos || end == std::string::npos)
            continue;
        const std::string_view all = line;
        const auto controllers = all.substr(begin + 1, end - begin - 1),
                   group = all.substr(end + 1);
        if (controllers.empty())
            least = std::min(least, least_around(mount, group, limit_of_second));
        else if (has_memory(controllers))
            least = std::min(least, least_around(first, group, limit_of_first));
    }
    return least;
}

} // namespace polydec
