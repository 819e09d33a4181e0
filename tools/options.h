// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"
#include "tools/answer.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace polydec::tools {

/// A subcommand, and what it is told: run(arguments) does its work when it is parsed.
template <class Arguments, class Run>
std::pair<CLI::App*, std::shared_ptr<Arguments>>
add_command(CLI::App& app, const std::string& name, const std::string& description, Run run) {
    auto* command = app.add_subcommand(name, description);
    const auto arguments = std::make_shared<Arguments>();
    command->callback([arguments, run] { run(*arguments); });
    return {command, arguments};
}

/// The options of every command: --json, and --max-memory, which sets memory_limit().
void add_common_options(CLI::App& command, TellOptions& options);

/// What is wrong with a text that should be a finite number of at least 0, or above 0; empty if
/// nothing is.
std::string check_not_negative(const std::string& text);
std::string check_positive(const std::string& text);

/// Complains of texts that are none of these names.
CLI::Validator one_of(std::vector<std::string> names);

/// The same; replaces a name by its place in the list, for enumerations of this order.
CLI::Validator enumerator(std::vector<std::string> names);

/// Numbers separated by commas, "1,0"; none for other texts.
std::optional<Vector> vector_of(std::string_view text);

/// The fault of a text that should be such a vector; empty if there is none.
std::string check_vector(const std::string& text);

/// Lets every option of the command and its subcommands report the expected value, if a value is
/// empty, not a number, or not finite. Call after adding all options.
void expect_values(CLI::App& app);

} // namespace polydec::tools
