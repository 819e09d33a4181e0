// SPDX-License-Identifier: MIT
#pragma once

#include "io/pages/draw_page.h"
#include "tools/answer.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>
#include <vector>

/// What a command shows of what it found, as a file by its extension: .vtu or .html.
namespace polydec::tools {

/// Where, and in which numbers.
struct PictureArguments {
    std::filesystem::path out = {}; ///< or empty
    VtuOptions vtu = {};
    Index isolines = 0; ///< how many level sets to write in place of the function
};

/// Adds -o to a subcommand, which says that it is `what` that is written, and --float32.
void add_picture(CLI::App& command, PictureArguments& picture, const std::string& what);

/// Adds --float32 alone, behind -o.
void add_float32(CLI::App& command, PictureArguments& picture);

/// Adds --isolines, for commands that find a function.
void add_isolines(CLI::App& command, PictureArguments& picture);

/// Refuses --float32 for files that are no .vtu.
void check_float32(const PictureArguments& picture);

/// Both checks of the file that is asked for, if one is: this one, and check_output_file; inputs
/// are the files of the mesh, and others.
void check_picture(const PictureArguments& picture, const std::filesystem::path& mesh,
                   const std::vector<std::filesystem::path>& others = {});

/// What the command line says, for pages; set once, by main.
void set_command_text(int argc, const char* const* argv);
const std::string& command_text();

/// Whether a path is that of a page.
bool is_page(const std::filesystem::path& out);

/// Writes these forms: in a page with the text beside them, the log's warnings and the command
/// line, and with segments along the surface, if any are given; in a .vtu file with these numbers
/// of the whole. Or the level sets of the first one.
void write_picture(const PictureArguments& to, const Discretization& mesh,
                   const std::vector<NamedForm>& forms, PageText text,
                   std::vector<VtuArray> numbers, const Log& log, const Mesh& lines = {});

/// The text with the log's warnings and the command line.
PageText in_page(PageText text, const Log& log);

/// Writes a page, with the log's warnings and the command line.
void write_page(const std::filesystem::path& out, Page page, const Log& log);

} // namespace polydec::tools
