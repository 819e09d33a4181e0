// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include <memory>

namespace polydec::tools {

/// The command line with all subcommands, which do their work when it is parsed.
std::unique_ptr<CLI::App> command_line();

} // namespace polydec::tools
