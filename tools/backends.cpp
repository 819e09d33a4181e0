// SPDX-License-Identifier: MIT
#include "backends/registry.h"
#include "examples/paper/console.h"
#include "tools/commands.h"
#include "tools/common.h"

#include <fmt/format.h>

#include <memory>

namespace polydec::tools {

namespace {

const char* kind_name(EngineKind kind) {
    switch (kind) {
    case EngineKind::linear:
        return "linear solver";
    case EngineKind::eigen:
        return "eigensolver";
    case EngineKind::mesher:
        return "mesher";
    }
    return "";
}

void run(bool json) {
    if (!json) {
        for (const auto& engine : engines())
            console::print("{:<16}{:<15}{:<9}{}{}\n", engine.name, kind_name(engine.kind),
                           engine.available ? "there" : "missing", engine.description,
                           engine.available ? ""
                                            : fmt::format("; to get it: {}", engine.how_to_get));
        return;
    }
    Json list = Json::array();
    for (const auto& engine : engines())
        list.push_back({{"name", engine.name},
                        {"kind", kind_name(engine.kind)},
                        {"available", engine.available},
                        {"description", engine.description},
                        {"how_to_get", engine.how_to_get}});
    console::print("{}\n", Json{{"backends", list}}.dump());
}

} // namespace

void add_backends(CLI::App& app) {
    auto* command = app.add_subcommand("backends", "engines: there, missing, how to get them");
    const auto json = std::make_shared<bool>(false);
    command->add_flag("--json", *json, "print one JSON object");
    command->footer("Example:\n  polydec backends");
    command->callback([json] { run(*json); });
}

} // namespace polydec::tools
