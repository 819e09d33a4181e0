// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>

namespace polydec {

/// Memory that the control groups of this process allow, in bytes: the minimum over its own group
/// and all enclosing groups, of control groups version 2 and 1; the largest number if there is no
/// limit. `groups` lists the groups; their files are below `mount`.
std::uint64_t control_group_memory(const std::filesystem::path& groups = "/proc/self/cgroup",
                                   const std::filesystem::path& mount = "/sys/fs/cgroup");

} // namespace polydec
