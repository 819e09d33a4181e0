// SPDX-License-Identifier: MIT
#include "base/listed.h"
#include "base/printable.h"
#include "distributed/mesh_file.h"
#include "io/source_file.h"
#include "tools/messages.h"
#include "tools/mpi/commands.h"
#include "tools/mpi/shared_mesh.h"
#include "tools/outputs.h"

#include <fmt/format.h>

namespace polydec::tools {

namespace {

struct ConvertArguments {
    std::filesystem::path mesh, out;
    TellOptions tell;
};

void run_convert(const Ranks& ranks, const ConvertArguments& arguments) {
    Log log;
    check_output_file(ranks, arguments.out, ".pdm");
    const SharedProgress progress(ranks);
    log.timing.begin("read");
    const MeshSlice slice =
        computed_on(arguments.mesh, [&] { return read_slice(ranks, arguments.mesh); });
    log.warn(slice.warnings);
    if (slice.has_tags && !ranks.any(!slice.tags.empty()))
        log.warn(fmt::format("left out the groups of {}: ranks read no groups in parts of {} files",
                             counted(static_cast<std::size_t>(slice.cells), "cell", "cells"),
                             lower_extension(arguments.mesh)));
    log.timing.begin("write");
    write_slice(ranks, arguments.out, slice);
    const std::string out = arguments.out.string();
    const auto members = [&](JsonWriter& json) {
        json.member("out", out);
        json.member("dimension", slice.dimension());
        json.member("vertices", slice.vertices);
        json.member("cells", slice.cells);
        json.object("ranks", [&] { json.member("count", ranks.size()); });
    };
    const auto words = [&](Text& text) {
        text("{}: {} vertices, {} cells of dimension {}\n", printable(out), slice.vertices,
             slice.cells, slice.dimension());
    };
    tell({members, words}, log, arguments.tell);
}

} // namespace

void add_convert(CLI::App& app, const Ranks& ranks) {
    const auto [command, arguments] = add_command<ConvertArguments>(
        app, "convert", "converts a mesh to .pdm, which ranks read in parts",
        [ranks](const ConvertArguments& given) { run_convert(ranks, given); });
    command->add_option("MESH", arguments->mesh, "mesh file, in any format that polydec reads")
        ->required()
        ->each(note_input);
    command->add_option("-o,--out", arguments->out, "FILE\tthe converted mesh, .pdm")->required();
    add_common_options(*command, arguments->tell);
    command->add_flag("--timing", arguments->tell.timing, "report how long each stage took");
    command->footer("The file has points, cells and their groups as in memory, and a checksum for "
                    "every MiB. Cells that occur twice or repeat a corner are omitted, and so are "
                    "the groups of .msh and .vtu files that ranks read in parts.\n\nExample:\n"
                    "  polydec-mpi convert engine.msh -o engine.pdm");
}

} // namespace polydec::tools
