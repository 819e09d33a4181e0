// SPDX-License-Identifier: MIT
#include "tools/messages.h"

#include "base/printable.h"

#include <fmt/format.h>

#include <array>
#include <string_view>

namespace polydec::tools {

namespace {

struct Wording {
    std::string_view member, option;
};

constexpr std::array wordings{
    Wording{"DiscretizeOptions::delaunay", "--delaunay"},
    Wording{"Delaunay::flips_and_splits", "--delaunay=split-boundary"},
    Wording{"StarKind::automatic", "--star automatic"},
    Wording{"StarKind::circumcentric", "--star circumcentric"},
    Wording{"Side::primal", "--side primal"},
    Wording{"GeodesicOptions::time_scale", "--time-scale"},
    Wording{"GeodesicOptions::linear_solver", "--engine"},
    Wording{"DistanceMethod::heat", "--method heat"},
    Wording{"Materials::keep_apart", "--keep-groups"},
    Wording{"MergeCriterion::none", "--no-merge"},
    Wording{"CellData::on_cells", "an expression"},
    Wording{"peeled(mesh)", "--peel"},
    Wording{"weld(mesh)", "--weld"},
    Wording{"join_hanging(mesh)", "--join-hanging"},
    Wording{"DiscretizeOptions::tolerance", "--tolerance"},
    Wording{"IntegratorOptions::relative_tolerance", "--tolerance-in-time"},
    Wording{"IntegratorOptions::fixed_step", "--time-step"},
    Wording{"WaveOptions::time_step", "--time-step"},
    Wording{"FlowSteps::time_step", "--time-step"},
    Wording{"set_memory_limit", "--max-memory"},
    Wording{"BoundaryConditions::essential", "--essential-where"},
    Wording{"FlowOptions::boundary_flux", "--boundary-velocity"},
    Wording{"FlowOptions::wall_velocity", "--boundary-velocity"},
    Wording{"FlowBoundary::open", "--open-where"},
    Wording{"longer steps or an earlier end", "a larger --time-step or a smaller --until"},
    Wording{"FlowScheme::imex", "--scheme imex"},
    Wording{"shape_spectrum", "--of-shape"},
};

void replace_all(std::string& text, std::string_view what, std::string_view by) {
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
        text.replace(at, what.size(), by);
}

} // namespace

std::string told(std::string message) {
    for (const auto& [member, option] : wordings)
        replace_all(message, member, option);
    return printable_message(message);
}

std::string naming(const std::filesystem::path& file, std::string message) {
    const std::string name = file.string();
    if (message.find(name) == std::string::npos)
        return fmt::format("{}: {}", printable(name), message);
    if (const auto shown = printable(name); shown != name)
        replace_all(message, name, shown);
    return message;
}

} // namespace polydec::tools
