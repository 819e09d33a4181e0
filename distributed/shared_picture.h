// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/discretize.h"
#include "io/pictures/vtu.h"

#include <filesystem>
#include <string>
#include <vector>

namespace polydec {

/// Values to be drawn: on own vertices, degree 0, or on own n-cells, degree n.
struct SharedValues {
    std::string name;
    int degree;
    Vector values;
};

/// Collective: writes the merged n-cells with these values, and each cell's owner rank, as .pvtu: a
/// list of .vtu files in a folder of the same name beside it, one per rank with cells. Folder and
/// list appear whole or not at all, the list last. An existing folder of that name must be empty or
/// hold an earlier result. Throws like check_drawable and write_vtu, IoError if writing fails on
/// any rank.
void write_pvtu(const Ranks& ranks, const std::filesystem::path& path, const DistributedMesh& mesh,
                const std::vector<SharedValues>& values, const VtuOptions& options = {});

} // namespace polydec
