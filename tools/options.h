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

/// The fault of a text that should be a finite number of at least 0; empty if there is none.
std::string check_not_negative(const std::string& text);

/// Numbers separated by commas, "1,0"; none for other texts.
std::optional<Vector> vector_of(std::string_view text);

/// The fault of a text that should be such a vector; empty if there is none.
std::string check_vector(const std::string& text);

/// Lets every option of the command and its subcommands report the expected value, if a value is
/// empty, not a number, or not finite. Call after adding all options.
void expect_values(CLI::App& app);

} // namespace polydec::tools
