// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/slices.h"

#include <filesystem>

namespace polydec {

/// Collective: the slices of a mesh in a file that all ranks see. For .pdm, and for files with a
/// MeshLayout (binary .ply, .msh and .vtu of simplices), each rank reads its own bytes, so that no
/// rank needs memory for the whole mesh. Rank 0 reads and scatters every other file, and files with
/// cells without volume or to be omitted. All are tidied as in discretize. Throws like read_mesh,
/// on all ranks; IoError if they see files of different length.
MeshSlice read_slice(const Ranks& ranks, const std::filesystem::path& path);

/// Collective: writes a mesh as .pdm, with its tags, each rank its part of the bytes. All ranks
/// must see the file, which appears whole or not at all. Throws InvalidInput for another extension,
/// IoError if writing fails on any rank.
void write_slice(const Ranks& ranks, const std::filesystem::path& path, const MeshSlice& slice);

} // namespace polydec
