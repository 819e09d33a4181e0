// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include <memory>
#include <string>

namespace polydec::tools {

/// The request does not run over several processes.
struct OneProcessOnly : CLI::ParseError {
    /// what: a command or option that exists in polydec's command of this name.
    OneProcessOnly(const std::string& what, const std::string& command);
};

/// A command line of this name without subcommands, with polydec's style of error messages.
std::unique_ptr<CLI::App> empty_command_line(const std::string& name,
                                             const std::string& description);

/// The command line with all subcommands; parsing it runs them.
std::unique_ptr<CLI::App> command_line();

} // namespace polydec::tools
