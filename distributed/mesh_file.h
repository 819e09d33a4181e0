// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/slices.h"

#include <filesystem>

namespace polydec {

/// Collective: the slices of a mesh in a file, which is the same for all ranks. Of .pdm, and of
/// files with a MeshLayout (binary .ply, .msh and .vtu of simplices), each rank reads its own
/// bytes, so that none needs the memory for all; every other file is read by rank 0 and scattered
/// from there, and so is one of which cells are to be left out. All but .pdm is tidied as
/// discretize does. Throws as read_mesh does, on all ranks; IoError if they see files of different
/// length.
MeshSlice read_slice(const Ranks& ranks, const std::filesystem::path& path);

/// Collective: writes a mesh as .pdm, each rank its part of the bytes; the file, which all ranks
/// must see, appears whole or not at all. Throws InvalidInput for another extension, IoError if
/// writing fails on any rank.
void write_slice(const Ranks& ranks, const std::filesystem::path& path, const MeshSlice& slice);

} // namespace polydec
