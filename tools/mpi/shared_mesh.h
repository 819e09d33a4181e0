// SPDX-License-Identifier: MIT
#pragma once

#include "dec/boundary/boundary_conditions.h"
#include "distributed/discretize.h"
#include "tools/common.h"

#include <CLI/CLI.hpp>

#include <filesystem>

namespace polydec::tools {

/// Arguments of every command over several ranks that reads a mesh.
struct SharedArguments {
    MeshArguments mesh;
    Ownership owners = Ownership::morton;
    std::filesystem::path out; ///< of commands that write files
};

/// Adds MESH and the options of SharedArguments to a subcommand; polydec's other options give an
/// error that names them.
void add_shared_arguments(CLI::App& command, SharedArguments& arguments);

/// Makes options of polydec errors, as they run in one process only.
void refuse_options(CLI::App& command, const std::vector<std::string>& options);

/// Collective: shows the progress of rank 0 during its lifetime.
class SharedProgress {
public:
    explicit SharedProgress(const Ranks& ranks);
    ~SharedProgress();
    SharedProgress(const SharedProgress&) = delete;
    SharedProgress& operator=(const SharedProgress&) = delete;

private:
    Ranks ranks_;
    ProgressLine progress_;
};

/// A log whose stages also count what this rank sends to others.
Log log_of(const Ranks& ranks);

/// Collective: reads, merges and measures the mesh; reports its warnings.
DistributedMesh load(const Ranks& ranks, const SharedArguments& arguments, Log& log);

/// Collective: the boundary facets of all ranks, under conditions other than Robin's.
BoundaryCounts boundary_counts(const Ranks& ranks, const DistributedMesh& mesh,
                               const BoundaryConditions& conditions);

/// For forms under conditions that are given in words.
FormFacts facts_of(const DistributedMesh& mesh, Side side, int degree, std::string conditions);

/// Collective: prints the answer, which all ranks have, with its effort and, if timing is
/// requested, the busiest rank's effort per stage.
void tell(const Ranks& ranks, const DistributedMesh& mesh, const Answer& answer, Log& log,
          const TellOptions& options);

/// Collective: checks the requested file, if any, on rank 0, before any work is done.
void check_output_file(const Ranks& ranks, const std::filesystem::path& out, const char* extension);

/// Adds -o OUT.pvtu; `what` describes the output.
void add_picture(CLI::App& command, std::filesystem::path& out, const std::string& what,
                 bool required);

} // namespace polydec::tools
