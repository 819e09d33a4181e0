// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

namespace polydec {

/// The bytes of memory that the control groups of this process allow: the least of its own group
/// and all around it, of the second version of control groups and the first; the largest number if
/// there is no limit. Which groups these are, `groups` tells; their files are below `mount`.
std::uint64_t control_group_memory(const std::filesystem::path& groups = "/proc/self/cgroup",
                                   const std::filesystem::path& mount = "/sys/fs/cgroup");

} // namespace polydec
