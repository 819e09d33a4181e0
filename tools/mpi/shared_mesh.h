// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/discretize.h"
#include "tools/common.h"
#include "tools/mpi/shared_log.h"

#include <CLI/CLI.hpp>

#include <filesystem>

namespace polydec::tools {

/// What every command over several ranks that reads a mesh is told.
struct SharedArguments {
    MeshArguments mesh;
    Ownership owners = Ownership::morton;
};

/// Adds MESH and the options of SharedArguments to a subcommand; options that polydec has besides
/// are refused by name.
void add_shared_arguments(CLI::App& command, SharedArguments& arguments);

/// Refuses an option of polydec: what it does runs in one process only.
void refuse_option(CLI::App& command, const std::string& option);

/// Collective: tells what is being done, on rank 0, until it goes.
class SharedProgress {
public:
    explicit SharedProgress(const Ranks& ranks);
    ~SharedProgress();
    SharedProgress(const SharedProgress&) = delete;
    SharedProgress& operator=(const SharedProgress&) = delete;

private:
    Ranks ranks_;
    Progress progress_;
};

/// Collective: reads, merges and measures the mesh; tells its warnings.
DistributedMesh load(const Ranks& ranks, const SharedArguments& arguments, SharedLog& log);

/// Collective: tells the answer, which all ranks have, with what it took them, and if the timing is
/// asked for what each stage took the busiest rank.
void tell(const Ranks& ranks, const DistributedMesh& mesh, const Answer& answer, SharedLog& log,
          const TellOptions& options);

/// Collective: check_output_file, on rank 0.
void check_output_file(const Ranks& ranks, const std::filesystem::path& out,
                       const std::vector<const char*>& extensions,
                       const std::filesystem::path& mesh);

/// Adds -o OUT.pvtu, which says that it is `what` that is written.
void add_picture(CLI::App& command, std::filesystem::path& out, const std::string& what,
                 bool required);

/// Collective: looks at the file that is asked for, if one is, before any work is done.
void check_picture(const Ranks& ranks, const std::filesystem::path& out,
                   const SharedArguments& arguments);

} // namespace polydec::tools
