// SPDX-License-Identifier: MIT
#include "distributed/shared_picture.h"
#include "tools/mpi/commands.h"
#include "tools/mpi/shared_mesh.h"
#include "tools/written.h"

namespace polydec::tools {

namespace {

void run_merge(const Ranks& ranks, const SharedArguments& arguments) {
    Log log = log_of(ranks);
    check_output_file(ranks, arguments.out, ".pvtu");
    const DistributedMesh mesh = load(ranks, arguments, log);
    log.timing.begin("write");
    write_pvtu(ranks, arguments.out, mesh, {});
    tell(ranks, mesh,
         merged(arguments.out.string(), mesh.dimension(), mesh.local.degrees.back().count,
                mesh.cells.degrees.back().count),
         log, arguments.mesh.tell);
}

} // namespace

void add_shared_merge(CLI::App& app, const Ranks& ranks) {
    const auto [command, arguments] = add_command<SharedArguments>(
        app, "merge", "writes the merged complex",
        [ranks](const SharedArguments& given) { run_merge(ranks, given); });
    add_shared_arguments(*command, *arguments);
    add_picture(*command, arguments->out, "polygons or polyhedra", true);
    refuse_options(*command, {"--star", "--float32"});
    command->footer(
        "The file says which rank owns each cell. For other formats use `polydec merge`.\n\n"
        "Example:\n  mpirun -n 4 polydec-mpi merge cubes.pdm -o cubes.pvtu");
}

} // namespace polydec::tools
