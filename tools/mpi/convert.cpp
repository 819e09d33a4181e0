// SPDX-License-Identifier: MIT
#include "base/printable.h"
#include "distributed/mesh_file.h"
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

class Converted : public Answer {
public:
    Converted(std::string out, const MeshSlice& slice, int ranks)
        : out_(std::move(out)),
          dimension_(slice.dimension()),
          ranks_(ranks),
          vertices_(slice.vertices),
          cells_(slice.cells) {}

    void write(JsonWriter& json) const override {
        json.member("out", out_);
        json.member("dimension", dimension_);
        json.member("vertices", vertices_);
        json.member("cells", cells_);
        json.object("ranks", [&] { json.member("count", ranks_); });
    }
    void write(Text& text) const override {
        text("{}: {} vertices, {} cells of dimension {}\n", printable(out_), vertices_, cells_,
             dimension_);
    }

private:
    std::string out_;
    int dimension_, ranks_;
    GlobalIndex vertices_, cells_;
};

void run_convert(const Ranks& ranks, const ConvertArguments& arguments) {
    Log log;
    check_output_file(ranks, arguments.out, {".pdm"});
    const SharedProgress progress(ranks);
    log.timing.begin("read");
    const MeshSlice slice =
        computed_on(arguments.mesh, [&] { return read_slice(ranks, arguments.mesh); });
    log.warn(slice.warnings);
    log.timing.begin("write");
    write_slice(ranks, arguments.out, slice);
    tell(Converted(arguments.out.string(), slice, ranks.size()), log, arguments.tell);
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
    command->footer("The file has points and cells as in memory, and a checksum for every MiB. "
                    "Cells that occur twice or repeat a corner are omitted.\n\nExample:\n"
                    "  polydec-mpi convert engine.msh -o engine.pdm");
}

} // namespace polydec::tools
