// SPDX-License-Identifier: MIT
#pragma once

#include "io/pages/page.h"
#include "tools/answer.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <string>
#include <vector>

/// Results of a command as a file in the format of the extension: .vtu, or a page or its picture.
namespace polydec::tools {

/// The path and the number format.
struct PictureArguments {
    std::filesystem::path out = {}; ///< or empty
    VtuOptions vtu = {};
    Index isolines = 0; ///< number of level sets to write instead of the function
};

/// Adds -o, with `what` as a description of the output, and --float32 to a subcommand.
void add_picture(CLI::App& command, PictureArguments& picture, const std::string& what);

/// Adds only --float32, after -o.
void add_float32(CLI::App& command, PictureArguments& picture);

/// Adds --isolines, for commands that compute a function.
void add_isolines(CLI::App& command, PictureArguments& picture);

/// Throws for --float32 with files other than .vtu.
void check_float32(const PictureArguments& picture);

/// Checks the page options, and the requested file, if any, by check_float32 and check_output_file.
void check_picture(const PictureArguments& picture);

/// The command line as text, for pages; main sets it once.
void set_command_text(int argc, const char* const* argv);

/// Adds --up and --length-unit, for commands that write a page; in_page applies them.
void add_page_options(CLI::App& command);

/// Throws for --up and --length-unit with files other than pages.
void check_page_options(const std::filesystem::path& out);

/// Whether a path has the extension of a page or of its picture: .html, .png, .svg.
bool is_page(const std::filesystem::path& out);

/// These extensions, then those of pages.
std::vector<const char*> and_pages(std::vector<const char*> extensions);

/// Writes these forms. A page has the text, the log's warnings, the command line and segments along
/// the surface, if given; a .vtu file has these numbers as field data. With isolines, writes the
/// level sets of the first form.
void write_picture(const PictureArguments& to, const Discretization& mesh,
                   const std::vector<NamedForm>& forms, PageText text,
                   std::vector<VtuArray> numbers, const Log& log, const Mesh& lines = {});

/// Text about the log's mesh file: what is shown of it, for the title, and facts.
PageText page_of(const Log& log, const std::string& what, std::vector<std::string> facts);

/// The text with the log's mesh file and warnings, the command line, and the page options.
PageText in_page(PageText text, const Log& log);

/// Writes a page, with the log's warnings and the command line.
void write_page(const std::filesystem::path& out, Page page, const Log& log);

} // namespace polydec::tools
