// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/slices.h"
#include "io/partial_file.h"

#include <optional>
#include <string>

namespace polydec {

/// Collective: the slices of a binary file with a MeshLayout, of which each rank reads its part of
/// the bytes: the very slices that scatter makes of tidy(read_mesh(file)). Nothing where one rank
/// has to read all of it, and `why`, which is empty for text.
std::optional<MeshSlice> read_parts(const Ranks& ranks, const PartialFile& file, std::string& why);

} // namespace polydec
