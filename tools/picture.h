// SPDX-License-Identifier: MIT
#pragma once

#include "io/pages/draw_page.h"
#include "tools/answer.h"

#include <filesystem>
#include <string>
#include <vector>

/// What a command shows of what it found, as a file by its extension: .vtu or .html.
namespace polydec::tools {

/// What the command line says, for pages; set once, by main.
void set_command_text(int argc, const char* const* argv);
const std::string& command_text();

/// Whether a path is that of a page.
bool is_page(const std::filesystem::path& out);

/// Writes what draw_page makes of these forms. In a page the text stands beside them, with the
/// log's warnings and the command line.
void write_picture(const std::filesystem::path& out, const Discretization& mesh,
                   const std::vector<NamedForm>& forms, PageText text, const Log& log);

/// The same for a page made otherwise, whose grid a .vtu file would have too.
void write_picture(const std::filesystem::path& out, Page page, const Log& log);

} // namespace polydec::tools
