// SPDX-License-Identifier: MIT
#include "distributed/operator_files.h"
#include "tools/mpi/commands.h"
#include "tools/mpi/shared_mesh.h"
#include "tools/outputs.h"
#include "tools/written.h"

namespace polydec::tools {

namespace {

void run_operators(const Ranks& ranks, const SharedArguments& arguments) {
    Log log = log_of(ranks);
    ranks.together("output", [&] {
        if (ranks.rank() == 0)
            check_replaced_folder(arguments.out);
    });
    const DistributedMesh mesh = load(ranks, arguments, log);
    log.timing.begin("write");
    log.warn(write_operators(ranks, mesh, arguments.out));
    tell(ranks, mesh, operators(arguments.out.string(), mesh.dimension()), log,
         arguments.mesh.tell);
}

} // namespace

void add_shared_operators(CLI::App& app, const Ranks& ranks) {
    const auto [command, arguments] = add_command<SharedArguments>(
        app, "operators", "writes all operators to files",
        [ranks](const SharedArguments& given) { run_operators(ranks, given); });
    add_shared_arguments(*command, *arguments);
    refuse_options(*command, {"--star"});
    command
        ->add_option("--out", arguments->out,
                     "FOLDER\tfolder for the files, created or replaced as a whole")
        ->required();
    command->footer("Files of the merged complex, in PETSc's binary format (.petsc): d_k star_k "
                    "volume_k dual_volume_k laplacian_primal_k laplacian_dual_j. Rows are in the "
                    "order of the cells, for any number of ranks. MatLoad, VecLoad and PETSc's "
                    "scripts for MATLAB and Python read them.\n"
                    "\n"
                    "Example:\n"
                    "  mpirun -n 4 polydec-mpi operators engine.pdm --out operators");
}

} // namespace polydec::tools
