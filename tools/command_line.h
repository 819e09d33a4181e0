// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace polydec::tools {

/// What is asked for does not run over several processes.
struct OneProcessOnly : CLI::ParseError {
    /// what: a command or option, that is there in this command of polydec.
    OneProcessOnly(const std::string& what, const std::string& command);
};

/// A command line of this name without subcommands, which says what is wrong as all of ours do.
std::unique_ptr<CLI::App> empty_command_line(const std::string& name,
                                             const std::string& description);

/// The command line with all subcommands, which do their work when it is parsed.
std::unique_ptr<CLI::App> command_line();

} // namespace polydec::tools
