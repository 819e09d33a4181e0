// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/slices.h"
#include "io/partial_file.h"

#include <optional>
#include <string>

namespace polydec {

/// Collective: the slices of a binary file with a MeshLayout, each rank reading its part of the
/// bytes; identical to scatter of read_mesh(file). None if one rank must read the whole file; then
/// `why` gives the reason, empty for text.
std::optional<MeshSlice> read_parts(const Ranks& ranks, const PartialFile& file, std::string& why);

/// Collective: whether no cell has a repeated corner, the vertices of another one, or no volume; if
/// not, `why` gives the first reason. Appends a warning about isolated vertices, as tidy does.
/// Coordinates must be finite, and vertices must exist.
bool is_tidy(const Ranks& ranks, MeshSlice& slice, std::string& why);

} // namespace polydec
