// SPDX-License-Identifier: MIT
#pragma once

namespace CLI {
class App;
class ParseError;
} // namespace CLI

namespace polydec {

/// Prints the requested help or version, or the error in the command line.
/// Returns the exit code, done or wrong_usage.
int tell_usage(const CLI::App& app, const CLI::ParseError& error);

} // namespace polydec
