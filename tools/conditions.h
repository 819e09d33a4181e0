// SPDX-License-Identifier: MIT
#pragma once

#include "dec/boundary_conditions.h"
#include "dec/discretization.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace polydec::tools {

/// What a command is told of the conditions on the boundary.
struct ConditionArguments {
    bool natural = false;
    std::string essential_where;
};

/// The options --natural and --essential-where, which exclude each other. Returns --natural.
CLI::Option* add_conditions(CLI::App& command, ConditionArguments& arguments,
                            const std::string& natural_help, const std::string& essential_help);

/// The conditions asked for; none if none were.
std::optional<BoundaryConditions> conditions(const Discretization& mesh,
                                             const ConditionArguments& arguments);

} // namespace polydec::tools
