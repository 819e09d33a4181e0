// SPDX-License-Identifier: MIT
#include "backends/blas.h"
#include "backends/registry.h"
#include "tools/commands.h"
#include "tools/options.h"

#include <fmt/format.h>

#include <array>
#include <memory>
#include <optional>

namespace polydec::tools {

namespace {

const char* kind_name(EngineKind kind) {
    constexpr std::array names{"linear solver", "eigensolver", "integrator", "mesher"};
    return names[static_cast<std::size_t>(kind)];
}

struct Backends {
    std::vector<EngineInfo> engines = polydec::engines();
    std::optional<Blas> blas = loaded_blas();

    void write(JsonWriter& json) const {
        json.objects("backends", engines, [&](const auto& engine) {
            json.member("name", engine.name);
            json.member("kind", kind_name(engine.kind));
            json.member("available", engine.available);
            json.member("description", engine.description);
            json.member("how_to_get", engine.how_to_get);
            json.member("license", engine.license);
        });
        if (blas)
            json.object("blas", [&] {
                json.member("name", blas->name);
                json.member("kernels", blas->kernels);
                json.member("threads", blas->threads);
                json.member("integer_bits", blas->integer_bits);
            });
    }

    void write(Text& text) const {
        for (const auto& engine : engines)
            text("{:<18}{:<15}{:<9}{}{}{}\n", engine.name, kind_name(engine.kind),
                 engine.available ? "there" : "missing", engine.description,
                 engine.license.empty() ? "" : "; license " + engine.license,
                 engine.available ? "" : fmt::format("; to get it: {}", engine.how_to_get));
        if (blas)
            text("BLAS of the engines: {}, kernels {}, {} thread{}, {}-bit integers\n", blas->name,
                 blas->kernels, blas->threads, blas->threads == 1 ? "" : "s", blas->integer_bits);
    }
};

} // namespace

void add_backends(CLI::App& app) {
    auto* command = app.add_subcommand("backends", "lists engines, and how to get missing ones");
    const auto options = std::make_shared<TellOptions>();
    add_common_options(*command, *options);
    command->footer("Example:\n  polydec backends");
    command->callback([options] {
        Log log;
        tell(Backends(), log, *options);
    });
}

} // namespace polydec::tools
