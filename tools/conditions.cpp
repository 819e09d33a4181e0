// SPDX-License-Identifier: MIT
#include "tools/conditions.h"

#include "dec/cell_centers.h"
#include "tools/expression.h"

namespace polydec::tools {

CLI::Option* add_conditions(CLI::App& command, ConditionArguments& arguments,
                            const std::string& natural_help, const std::string& essential_help) {
    auto* natural = command.add_flag("--natural", arguments.natural, natural_help);
    command.add_option("--essential-where", arguments.essential_where, essential_help)
        ->excludes(natural);
    return natural;
}

std::optional<BoundaryConditions> conditions(const Discretization& mesh,
                                             const ConditionArguments& arguments) {
    if (arguments.natural)
        return BoundaryConditions{BoundaryCondition::natural};
    if (arguments.essential_where.empty())
        return std::nullopt;
    const Points sites = cell_centers(mesh, mesh.dimension() - 1);
    const Vector holds = values_at("--essential-where", arguments.essential_where, sites);
    BoundaryConditions result;
    for (const double value : holds)
        result.facets.push_back(value != 0 ? BoundaryCondition::essential
                                           : BoundaryCondition::natural);
    return result;
}

} // namespace polydec::tools
