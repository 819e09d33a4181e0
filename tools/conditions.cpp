// SPDX-License-Identifier: MIT
#include "tools/conditions.h"

#include "base/errors.h"
#include "dec/fields/cell_centers.h"
#include "dec/fields/chosen_cells.h"
#include "tools/form_values.h"
#include "tools/messages.h"
#include "tools/options.h"

#include <fmt/format.h>

#include <algorithm>

namespace polydec::tools {

CLI::Option* add_conditions(CLI::App& command, ConditionArguments& arguments,
                            const std::string& natural_help, const std::string& essential_help) {
    auto* natural = command.add_flag("--natural", arguments.natural, natural_help);
    command.add_option("--essential-where", arguments.essential_where, "EXPR\t" + essential_help)
        ->excludes(natural);
    command
        .add_option(
            "--essential-on", arguments.essential_on,
            "GROUP ..\tthe same on these physical groups (name or number); see --keep-groups")
        ->excludes(natural)
        ->excludes("--essential-where");
    return natural;
}

void add_fixed(CLI::App& command, ConditionArguments& arguments, const std::string& values) {
    command.add_option("--fixed-where", arguments.fixed_where,
                       "EXPR\t" + values + " also at vertices where this is not 0, else natural");
}

void add_robin(CLI::App& command, ConditionArguments& arguments, const std::string& data) {
    command
        .add_option("--robin", arguments.robin,
                    "ALPHA\tRobin: outward derivative + ALPHA u = " + data +
                        " except at --essential-* facets")
        ->check(check_positive)
        ->excludes("--natural");
}

ConditionValues::ConditionValues(const ConditionArguments& arguments)
    : natural_(arguments.natural),
      essential_on_(arguments.essential_on),
      robin_(arguments.robin),
      essential_where_(if_given<SiteValues>("--essential-where", arguments.essential_where)),
      fixed_where_(if_given<SiteValues>("--fixed-where", arguments.fixed_where)) {}

std::optional<BoundaryConditions> ConditionValues::on(const Discretization& mesh) const {
    const auto conditions = without_robin(mesh);
    if (robin_ == 0)
        return conditions;
    auto with_robin = robin_elsewhere(
        conditions.value_or(BoundaryConditions{BoundaryCondition::natural}), robin_);
    require_use(boundary_counts(mesh.complex(), with_robin), {.robin = "--robin"});
    return with_robin;
}

FormSpace ConditionValues::space(const Discretization& mesh, Side side, int degree,
                                 const std::filesystem::path& file) const {
    return computed_on(file, [&] {
        return FormSpace(mesh, side, degree, on(mesh).value_or(built_in_conditions(side)));
    });
}

std::optional<BoundaryConditions> ConditionValues::without_robin(const Discretization& mesh) const {
    BoundaryConditions result{BoundaryCondition::natural};
    if (!essential_on_.empty())
        result = essential_on(mesh, essential_on_);
    else if (essential_where_) {
        for (const double value : essential_where_->at(facet_sites(mesh)))
            result.facets.push_back(value != 0 ? BoundaryCondition::essential
                                               : BoundaryCondition::natural);
        require_use(boundary_counts(mesh.complex(), result), {.values = "--essential-where"});
    } else if (!natural_ && !fixed_where_)
        return std::nullopt;
    if (fixed_where_) {
        for (const double value : vertex_values(mesh, *fixed_where_, cell_centers(mesh, 0)))
            result.fixed_vertices.push_back(value != 0);
        if (std::count(result.fixed_vertices.begin(), result.fixed_vertices.end(), true) == 0)
            throw InvalidInput(
                fmt::format("--fixed-where is 0 at all {} vertices", result.fixed_vertices.size()));
    }
    return result;
}

} // namespace polydec::tools
