// SPDX-License-Identifier: MIT
#include "tools/conditions.h"

#include "base/errors.h"
#include "dec/facet_groups.h"
#include "dec/fields/cell_centers.h"

#include <fmt/format.h>

#include <algorithm>

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

void add_fixed(CLI::App& command, ConditionArguments& arguments, const std::string& values) {
    command.add_option("--fixed-where", arguments.fixed_where,
                       values +
                           " given at vertices where this is\n"
                           "not 0, inside as well; on the boundary only what other options say");
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
    if (!arguments.fixed_where.empty())
        fixed_where_.emplace("--fixed-where", arguments.fixed_where);
}

std::optional<BoundaryConditions> ConditionValues::on(const Discretization& mesh) const {
    const auto conditions = without_robin(mesh);
    if (robin_ == 0)
        return conditions;
    return robin_elsewhere(conditions.value_or(BoundaryConditions{BoundaryCondition::natural}),
                           robin_);
}

FormSpace ConditionValues::space(const Discretization& mesh, Side side, int degree) const {
    return {mesh, side, degree, on(mesh).value_or(built_in_conditions(side))};
}

std::optional<BoundaryConditions> ConditionValues::without_robin(const Discretization& mesh) const {
    BoundaryConditions result{BoundaryCondition::natural};
    if (!essential_on_.empty())
        result = essential_on(mesh, essential_on_);
    else if (essential_where_) {
        for (const double value : essential_where_->at(facet_sites(mesh)))
            result.facets.push_back(value != 0 ? BoundaryCondition::essential
                                               : BoundaryCondition::natural);
        require_essential(mesh.complex(), result, "--essential-where");
    } else if (!natural_ && !fixed_where_)
        return std::nullopt;
    if (fixed_where_) {
        for (const double value : fixed_where_->at(cell_centers(mesh, 0)))
            result.fixed_vertices.push_back(value != 0);
        if (std::count(result.fixed_vertices.begin(), result.fixed_vertices.end(), true) == 0)
            throw InvalidInput(fmt::format("--fixed-where: it is 0 at all {} vertices: expected "
                                           "some",
                                           result.fixed_vertices.size()));
    }
    return result;
}

std::optional<std::filesystem::path> ConditionValues::file() const {
    return essential_where_ ? essential_where_->file() : std::nullopt;
}

std::optional<std::filesystem::path> ConditionValues::fixed_file() const {
    return fixed_where_ ? fixed_where_->file() : std::nullopt;
}

} // namespace polydec::tools
