// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace polydec::tools {

/// The text of --help, of every command: usage, options in groups, kinds of values, footer; in
/// lines of at most 100 columns. A description may begin with a name for the value and a tab,
/// "TIME\tend of the run"; defaults that are not 0 are added.
class Help : public CLI::Formatter {
public:
    std::string make_help(const CLI::App* app, std::string name,
                          CLI::AppFormatMode mode) const override;
};

/// The names of the subcommands that help lists.
std::vector<std::string> commands_of(const CLI::App& app);

/// An option with the name of its value: "--until TIME".
std::string with_value(const CLI::Option& option);

/// The description without the name of the value.
std::string description_of(const CLI::Option& option);

} // namespace polydec::tools
