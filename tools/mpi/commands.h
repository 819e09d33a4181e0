// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/ranks.h"

#include <CLI/CLI.hpp>

/// One function per subcommand over several ranks, as for polydec.
namespace polydec::tools {

void add_shared_info(CLI::App& app, const Ranks& ranks);
void add_shared_merge(CLI::App& app, const Ranks& ranks);
void add_shared_operators(CLI::App& app, const Ranks& ranks);
void add_shared_poisson(CLI::App& app, const Ranks& ranks);
void add_shared_spectrum(CLI::App& app, const Ranks& ranks);
void add_convert(CLI::App& app, const Ranks& ranks);

} // namespace polydec::tools
