// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/discretize.h"
#include "io/pictures/vtu.h"

#include <filesystem>
#include <string>
#include <vector>

namespace polydec {

/// Numbers to be seen: of own vertices, degree 0, or of own n-cells, degree n.
struct SharedValues {
    std::string name;
    int degree;
    Vector values;
};

/// Collective: writes the merged n-cells with these numbers, and of each cell the rank that owns
/// it, as .pvtu: a list of .vtu files in a folder beside it that has its name, which each rank
/// writes one of; ranks without cells have none. Folder and list appear whole or not at all, the
/// list last. A folder of that name must hold an earlier result or nothing. Throws like
/// check_drawable and write_vtu, IoError if writing fails on any rank.
void write_pvtu(const Ranks& ranks, const std::filesystem::path& path, const DistributedMesh& mesh,
                const std::vector<SharedValues>& values, const VtuOptions& options = {});

} // namespace polydec
