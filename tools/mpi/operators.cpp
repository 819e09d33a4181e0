// SPDX-License-Identifier: MIT
#include "base/printable.h"
#include "distributed/operator_files.h"
#include "tools/mpi/commands.h"
#include "tools/mpi/shared_mesh.h"
#include "tools/outputs.h"

#include <memory>

namespace polydec::tools {

namespace {

struct SharedOperatorsArguments {
    SharedArguments mesh;
    std::filesystem::path out;
};

class SharedOperators : public Answer {
public:
    SharedOperators(std::string out, int dimension) : out_(std::move(out)), dimension_(dimension) {}

    void write(JsonWriter& json) const override {
        json.member("out", out_);
        json.member("dimension", dimension_);
    }
    void write(Text& text) const override {
        text("operators of degrees 0 .. {} written to {}\n", dimension_, printable(out_));
    }

private:
    std::string out_;
    int dimension_;
};

void run_operators(const Ranks& ranks, const SharedOperatorsArguments& arguments) {
    SharedLog log(ranks);
    ranks.together("output", [&] {
        if (ranks.rank() == 0)
            check_replaced_folder(arguments.out);
    });
    const DistributedMesh mesh = load(ranks, arguments.mesh, log);
    log.begin("write");
    for (const auto& why : write_operators(ranks, mesh, arguments.out))
        log.warn(why);
    tell(ranks, mesh, SharedOperators(arguments.out.string(), mesh.dimension()), log,
         arguments.mesh.mesh.tell);
}

} // namespace

void add_shared_operators(CLI::App& app, const Ranks& ranks) {
    auto* command = app.add_subcommand("operators", "writes every operator as files");
    const auto arguments = std::make_shared<SharedOperatorsArguments>();
    add_shared_arguments(*command, arguments->mesh);
    refuse_option(*command, "--star");
    command
        ->add_option("--out", arguments->out, "folder for the files, made or replaced as a whole")
        ->required();
    command->footer(
        "Files of the merged complex, in PETSc's binary format: d_k star_k volume_k dual_volume_k\n"
        "laplacian_primal_k laplacian_dual_j, with the extension .petsc; rows in the order of "
        "cells,\nhowever many ranks there are. MatLoad and VecLoad read them, and so do PETSc's "
        "scripts for\nMATLAB and Python.\n\nExample:\n"
        "  mpirun -n 4 polydec-mpi operators engine.pdm --out operators");
    command->callback([ranks, arguments] { run_operators(ranks, *arguments); });
}

} // namespace polydec::tools
