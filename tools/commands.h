// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>

/// One function per subcommand: it adds the subcommand, which does its work when parsed.
namespace polydec::tools {

void add_info(CLI::App& app);
void add_operators(CLI::App& app);
void add_merge(CLI::App& app);
void add_view(CLI::App& app);
void add_draw(CLI::App& app);
void add_spectrum(CLI::App& app);
void add_poisson(CLI::App& app);
void add_hodge(CLI::App& app);
void add_heat(CLI::App& app);
void add_wave(CLI::App& app);
void add_maxwell(CLI::App& app);
void add_flow(CLI::App& app);
void add_distance(CLI::App& app);
void add_generate(CLI::App& app);
void add_reproduce(CLI::App& app);
void add_backends(CLI::App& app);

} // namespace polydec::tools
