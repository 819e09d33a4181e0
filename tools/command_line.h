// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace polydec::tools {

/// A command line of this name without subcommands, which says what is wrong as all of ours do.
std::unique_ptr<CLI::App> empty_command_line(const std::string& name,
                                             const std::string& description);

/// The command line with all subcommands, which do their work when it is parsed.
std::unique_ptr<CLI::App> command_line();

} // namespace polydec::tools
