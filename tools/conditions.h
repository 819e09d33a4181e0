// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/forms/boundary_conditions.h"
#include "tools/expression.h"

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

/// The conditions asked for, on any mesh. Made before any work, like SiteValues.
class ConditionValues {
public:
    /// Throws like SiteValues.
    explicit ConditionValues(const ConditionArguments& arguments);

    /// On the facets of this mesh; none if none were asked for. Throws like SiteValues::at.
    std::optional<BoundaryConditions> on(const Discretization& mesh) const;

    /// The file that says where, if one does.
    std::optional<std::filesystem::path> file() const;

private:
    bool natural_;
    std::optional<SiteValues> essential_where_;
};

} // namespace polydec::tools
