// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/form_space.h"
#include "tools/expression.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace polydec::tools {

/// What a command is told of the conditions on the boundary.
struct ConditionArguments {
    bool natural = false;
    std::string essential_where;
    std::vector<std::string> essential_on;
    std::string fixed_where;
    double robin = 0; ///< coefficient of Robin's condition in place of the natural one; 0: none
};

/// The options --natural and --essential-where, which exclude each other. Returns --natural.
CLI::Option* add_conditions(CLI::App& command, ConditionArguments& arguments,
                            const std::string& natural_help, const std::string& essential_help);

/// The option --essential-on, which excludes both of these: physical groups or other tags of the
/// file.
void add_essential_on(CLI::App& command, ConditionArguments& arguments);

/// The option --fixed-where, of primal 0-forms; `values` is the option that gives them.
void add_fixed(CLI::App& command, ConditionArguments& arguments, const std::string& values);

/// The option --robin, by which these data are the outward derivative plus ALPHA u.
void add_robin(CLI::App& command, ConditionArguments& arguments, const std::string& data);

/// The conditions asked for, on any mesh. Made before any work, like SiteValues.
class ConditionValues {
public:
    /// Throws like SiteValues.
    explicit ConditionValues(const ConditionArguments& arguments);

    /// On the facets of this mesh; none if none were asked for. Throws like SiteValues::at,
    /// polydec::essential_on and require_essential.
    std::optional<BoundaryConditions> on(const Discretization& mesh) const;

    /// The forms of this side and degree under them, or under the built-in ones.
    FormSpace space(const Discretization& mesh, Side side, int degree) const;

    /// The file that says where, if one does; of facets, and of vertices.
    std::optional<std::filesystem::path> file() const;
    std::optional<std::filesystem::path> fixed_file() const;

private:
    std::optional<BoundaryConditions> without_robin(const Discretization& mesh) const;

    bool natural_;
    std::vector<std::string> essential_on_;
    double robin_;
    std::optional<SiteValues> essential_where_, fixed_where_;
};

} // namespace polydec::tools
