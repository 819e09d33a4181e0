// SPDX-License-Identifier: MIT
#pragma once

#include "dec/boundary/form_space.h"
#include "dec/discretization/discretization.h"
#include "tools/expression.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace polydec::tools {

/// A command's arguments for boundary conditions.
struct ConditionArguments {
    bool natural = false;
    std::string essential_where;
    std::vector<std::string> essential_on;
    std::string fixed_where;
    double robin = 0; ///< Robin coefficient, replaces the natural condition; 0: none
};

/// The options --natural, --essential-where and --essential-on, which exclude each other. Returns
/// --natural.
CLI::Option*
add_conditions(CLI::App& command, ConditionArguments& arguments,
               const std::string& natural_help =
                   "no flow (Neumann), degrees 1 .. n-1: normal part 0; default of primal forms",
               const std::string& essential_help =
                   "values 0 (Dirichlet), degrees 1 .. n-1: tangential part 0, at boundary facets "
                   "where this is not 0, no flow elsewhere; default of dual forms: 1");

/// Adds the option --fixed-where, for primal 0-forms; `values` is the option with their values.
void add_fixed(CLI::App& command, ConditionArguments& arguments, const std::string& values);

/// Adds the option --robin; `data` then give the outward derivative plus ALPHA u.
void add_robin(CLI::App& command, ConditionArguments& arguments, const std::string& data);

/// The requested conditions, for any mesh. Construct before any work, like SiteValues.
class ConditionValues {
public:
    /// Throws like SiteValues.
    explicit ConditionValues(const ConditionArguments& arguments);

    /// On the facets of this mesh; none if no conditions were requested. Throws like
    /// SiteValues::at, polydec::essential_on and require_use.
    std::optional<BoundaryConditions> on(const Discretization& mesh) const;

    /// The forms of this side and degree under these conditions, or under the default ones. Errors
    /// name the file of the mesh.
    FormSpace space(const Discretization& mesh, Side side, int degree,
                    const std::filesystem::path& file) const;

private:
    std::optional<BoundaryConditions> without_robin(const Discretization& mesh) const;

    bool natural_;
    std::vector<std::string> essential_on_;
    double robin_;
    std::optional<SiteValues> essential_where_, fixed_where_;
};

} // namespace polydec::tools
