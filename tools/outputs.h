// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"

#include <filesystem>
#include <vector>

/// Where a command writes is looked at before any work is done.
namespace polydec::tools {

using Paths = std::vector<std::filesystem::path>;

/// The files that a mesh of this name is read from: TetGen's are several.
Paths mesh_files(const std::filesystem::path& mesh);

/// Throws InvalidInput if the extension, in any case of its letters, is none of those, or the file
/// is one of the inputs, by whatever name; IoError if it cannot be written: its folder is not there
/// or not writable, it is no regular file, or it is read-only.
void check_output_file(const std::filesystem::path& out, const std::vector<const char*>& extensions,
                       const Paths& inputs);

/// The same for a folder, which is there or can be made, with all folders on the way to it.
void check_output_folder(const std::filesystem::path& out);

/// The same for a folder that is made anew beside what is there and takes its place, so that the
/// folder around it must be writable too.
void check_replaced_folder(const std::filesystem::path& out);

/// Throws InvalidInput, with advice, if a .vtu file cannot show cells of this mesh.
void check_drawable(const Discretization& mesh);

} // namespace polydec::tools
