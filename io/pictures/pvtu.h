// SPDX-License-Identifier: MIT
#pragma once

#include "io/pictures/vtu.h"

#include <filesystem>
#include <string>
#include <vector>

namespace polydec {

/// Writes VTK's XML PUnstructuredGrid (.pvtu): the list of .vtu files that form one picture, by
/// their paths from its own folder, all with the arrays of this grid. The file appears whole or not
/// at all. Throws IoError if writing fails.
void write_pvtu(const std::filesystem::path& path, const VtuGrid& one,
                const std::vector<std::string>& pieces, const VtuOptions& options = {});

} // namespace polydec
