// SPDX-License-Identifier: MIT
#include "tools/conditions.h"

#include "dec/conditioned_complex.h"
#include "dec/fields/cell_centers.h"

namespace polydec::tools {

CLI::Option* add_conditions(CLI::App& command, ConditionArguments& arguments,
                            const std::string& natural_help, const std::string& essential_help) {
    auto* natural = command.add_flag("--natural", arguments.natural, natural_help);
    command.add_option("--essential-where", arguments.essential_where, essential_help)
        ->excludes(natural);
    return natural;
}

void add_essential_on(CLI::App& command, ConditionArguments& arguments) {
    command
        .add_option("--essential-on", arguments.essential_on,
                    "the same at boundary facets of these physical groups of the file, by\n"
                    "name or number; with --keep-groups merging joins none of them")
        ->excludes("--natural")
        ->excludes("--essential-where");
}

void add_robin(CLI::App& command, ConditionArguments& arguments, const std::string& data) {
    command
        .add_option("--robin", arguments.robin,
                    "ALPHA > 0: where no values are given, " + data +
                        " is the outward derivative\n"
                        "plus ALPHA u (Robin). Without --essential-where or --essential-on\n"
                        "values are given nowhere")
        ->check(CLI::PositiveNumber);
}

ConditionValues::ConditionValues(const ConditionArguments& arguments)
    : natural_(arguments.natural), essential_on_(arguments.essential_on), robin_(arguments.robin) {
    if (!arguments.essential_where.empty())
        essential_where_.emplace("--essential-where", arguments.essential_where);
}

std::optional<BoundaryConditions> ConditionValues::on(const Discretization& mesh) const {
    const auto conditions = without_robin(mesh);
    if (robin_ == 0)
        return conditions;
    // coefficients are 1 over lengths of the file
    return robin_elsewhere(conditions.value_or(BoundaryConditions{BoundaryCondition::natural}),
                           robin_ * mesh.unit());
}

std::optional<BoundaryConditions> ConditionValues::without_robin(const Discretization& mesh) const {
    if (natural_)
        return BoundaryConditions{BoundaryCondition::natural};
    if (!essential_on_.empty())
        return essential_on(mesh, essential_on_);
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
