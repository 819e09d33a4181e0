// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace polydec::tools {

/// A table of all commands and options, for scripts that make manual pages and completions of
/// shells (cmake/shell_files.py). Lines with tabs between the columns, in the order of --help:
///     command  PATH  DESCRIPTION
///     option   PATH  NAMES, with blanks between them  1 if it takes a value, else 0  DESCRIPTION
/// PATH is the command's words with blanks between them; empty for options of the program itself.
std::string description(const CLI::App& app);

} // namespace polydec::tools
