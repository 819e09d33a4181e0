// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace polydec::tools {

/// Arguments for joining a mesh that is read.
struct JoiningArguments {
    std::string weld; ///< empty; or the length, a number, or else weld_length
    bool hanging = false;

    bool are_given() const { return !weld.empty() || hanging; }
};

/// Adds the options --weld and --join-hanging to a command that reads a mesh.
void add_joining(CLI::App& command, JoiningArguments& arguments);

/// The mesh of a file, joined by these arguments.
Mesh read_joined(const std::filesystem::path& file, const JoiningArguments& arguments);

/// The words of a command line without the program's name. A number after --weld is attached, as in
/// --weld=1e-6: a flag may have a value, but the parser takes the next word for MESH.
std::vector<std::string> words_of(int argc, char** argv);

} // namespace polydec::tools
