// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"
#include "tools/answer.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <string_view>

namespace polydec::tools {

/// The options of every command: --json, and --max-memory, which sets memory_limit().
void add_common_options(CLI::App& command, TellOptions& options);

/// What is wrong with a text that should be a finite number of at least 0; empty if nothing is.
std::string check_not_negative(const std::string& text);

/// Numbers with commas between, "1,0"; none if a text is something else.
std::optional<Vector> vector_of(std::string_view text);

/// What is wrong with a text that should be that; empty if nothing is.
std::string check_vector(const std::string& text);

/// Lets every option of the command and its subcommands say what it expects, where a value is
/// empty, no number, or no finite one. To be called when all are there.
void expect_values(CLI::App& app);

} // namespace polydec::tools
