// SPDX-License-Identifier: MIT
#pragma once

namespace CLI {
class App;
class ParseError;
} // namespace CLI

namespace polydec {

/// Prints the help or version that was asked for, or tells what is wrong with the command line.
/// Returns the exit code, done or wrong_usage.
int tell_usage(const CLI::App& app, const CLI::ParseError& error);

} // namespace polydec
