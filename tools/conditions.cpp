// SPDX-License-Identifier: MIT
#include "tools/conditions.h"

#include "dec/fields/cell_centers.h"

namespace polydec::tools {

CLI::Option* add_conditions(CLI::App& command, ConditionArguments& arguments,
                            const std::string& natural_help, const std::string& essential_help) {
    auto* natural = command.add_flag("--natural", arguments.natural, natural_help);
    command.add_option("--essential-where", arguments.essential_where, essential_help)
        ->excludes(natural);
    return natural;
}

ConditionValues::ConditionValues(const ConditionArguments& arguments)
    : natural_(arguments.natural) {
    if (!arguments.essential_where.empty())
        essential_where_.emplace("--essential-where", arguments.essential_where);
}

std::optional<BoundaryConditions> ConditionValues::on(const Discretization& mesh) const {
    if (natural_)
        return BoundaryConditions{BoundaryCondition::natural};
    if (!essential_where_)
        return std::nullopt;
    const Points sites = mesh.unit() * facet_sites(mesh);
    BoundaryConditions result;
    for (const double value : essential_where_->at(sites))
        result.facets.push_back(value != 0 ? BoundaryCondition::essential
                                           : BoundaryCondition::natural);
    return result;
}

std::optional<std::filesystem::path> ConditionValues::file() const {
    return essential_where_ ? essential_where_->file() : std::nullopt;
}

} // namespace polydec::tools
