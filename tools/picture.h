// SPDX-License-Identifier: MIT
#pragma once

#include "io/pages/page.h"
#include "tools/answer.h"

#include <filesystem>
#include <span>
#include <string>
#include <utility>

/// What a command shows of what it found, as a file by its extension: .vtu or .html.
namespace polydec::tools {

/// A form on the mesh, by the name it has in the picture, and what it is in words.
struct NamedForm {
    std::string name;
    Cochain form;
    std::string about;

    NamedForm(std::string title, Cochain values, std::string words)
        : name(std::move(title)), form(std::move(values)), about(std::move(words)) {}
};

/// What the command line says, for pages; set once, by main.
void set_command_text(int argc, const char* const* argv);
const std::string& command_text();

/// Whether a path is that of a page.
bool is_page(const std::filesystem::path& out);

/// Writes forms that live on the same cells, all on primal or dual k-cells of one k; where there
/// are none, the cells themselves. In a page the text stands beside them, with the log's warnings
/// and the command line; of fields of degree 1 it shows arrows too.
void write_picture(const std::filesystem::path& out, const Discretization& mesh,
                   std::span<const NamedForm> forms, PageText text, const Log& log);

/// The same for a page made otherwise, whose grid a .vtu file would have too.
void write_picture(const std::filesystem::path& out, Page page, const Log& log);

/// The cells of the mesh that was read from this file, with their tags, for write_picture; after
/// flips as they lie over the input's triangles. In a page their volumes and numbers of corners are
/// there to be chosen.
Page page_of_cells(const std::filesystem::path& out, const Discretization& mesh,
                   const std::filesystem::path& file);

} // namespace polydec::tools
