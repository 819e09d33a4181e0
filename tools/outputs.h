// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization/discretization.h"

#include <filesystem>
#include <vector>

/// Checks of output paths, before any work is done.
namespace polydec::tools {

using Paths = std::vector<std::filesystem::path>;

/// The files of a mesh with this name; TetGen's has several.
Paths mesh_files(const std::filesystem::path& mesh);

/// Notes an input of this command, a mesh with all its files or a file of numbers, wherever its
/// name becomes known: no output may replace it.
void note_input(const std::filesystem::path& file);

/// Throws InvalidInput if the extension, in any case, is not in the list, or if the file, or a step
/// or piece in the folder beside it, is a noted input, under any name; IoError if it is not
/// writable: its folder is missing or not writable, it is not a regular file, or it is read-only.
void check_output_file(const std::filesystem::path& out,
                       const std::vector<const char*>& extensions);

/// The same for a folder that exists or can be made, with all parent folders.
void check_output_folder(const std::filesystem::path& out);

/// The same for a folder that is rebuilt beside the old one and replaces it, so that its parent
/// must also be writable.
void check_replaced_folder(const std::filesystem::path& out);

/// Throws InvalidInput, with advice, if a .vtu file cannot show cells of this mesh.
void check_drawable(const Discretization& mesh);

} // namespace polydec::tools
