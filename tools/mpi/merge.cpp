// SPDX-License-Identifier: MIT
#include "base/printable.h"
#include "distributed/shared_picture.h"
#include "tools/mpi/commands.h"
#include "tools/mpi/shared_mesh.h"

namespace polydec::tools {

namespace {

struct SharedMergeArguments {
    SharedArguments mesh;
    std::filesystem::path out;
};

class SharedMerged : public Answer {
public:
    SharedMerged(std::string out, const DistributedMesh& mesh)
        : out_(std::move(out)),
          dimension_(mesh.dimension()),
          input_(mesh.local.degrees.back().count),
          merged_(mesh.cells.degrees.back().count) {}

    void write(JsonWriter& json) const override {
        json.member("out", out_);
        json.member("dimension", dimension_);
        json.object("cells", [&] {
            json.member("input", input_);
            json.member("merged", merged_);
        });
    }
    void write(Text& text) const override {
        text("{}: {} cells of dimension {} merged into {}\n", printable(out_), input_, dimension_,
             merged_);
    }

private:
    std::string out_;
    int dimension_;
    GlobalIndex input_, merged_;
};

void run_merge(const Ranks& ranks, const SharedMergeArguments& arguments) {
    SharedLog log(ranks);
    check_picture(ranks, arguments.out, arguments.mesh);
    const DistributedMesh mesh = load(ranks, arguments.mesh, log);
    log.begin("write");
    write_pvtu(ranks, arguments.out, mesh, {});
    tell(ranks, mesh, SharedMerged(arguments.out.string(), mesh), log, arguments.mesh.mesh.tell);
}

} // namespace

void add_shared_merge(CLI::App& app, const Ranks& ranks) {
    const auto [command, arguments] = add_command<SharedMergeArguments>(
        app, "merge", "writes the merged complex",
        [ranks](const SharedMergeArguments& given) { run_merge(ranks, given); });
    add_shared_arguments(*command, arguments->mesh);
    refuse_option(*command, "--star");
    add_picture(*command, arguments->out, "polygons or polyhedra", true);
    refuse_option(*command, "--float32");
    command->footer(
        "The file says which rank owns each cell. For other formats use `polydec merge`.\n\n"
        "Example:\n  mpirun -n 4 polydec-mpi merge cubes.pdm -o cubes.pvtu");
}

} // namespace polydec::tools
