// SPDX-License-Identifier: MIT
#include "base/printable.h"
#include "examples/paper/process.h"
#include "examples/paper/usage.h"
#include "tools/commands.h"
#include "tools/messages.h"
#include "tools/options.h"
#ifdef POLYDEC_HAS_CHOLMOD
#include "backends/cholmod.h"
#endif
#ifdef POLYDEC_HAS_PETSC
#include "backends/petsc.h"
#endif
#ifdef POLYDEC_HAS_SLEPC
#include "backends/slepc.h"
#endif

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <string>

namespace {

/// An argument that nobody knows is the cause even where something is missing too.
std::string tell_misuse(const CLI::App* app, const CLI::Error& error) {
    using polydec::tools::told;
    const auto unknown = app->remaining(true);
    if (unknown.empty())
        return fmt::format("polydec: {}\nRun with --help for more information.\n",
                           told(error.what()));
    const auto& first = unknown.front();
    const bool dash = first.size() > 1 && first[0] == '-' && first[1] != '-';
    return fmt::format("polydec: there is no '{}' here{}\nRun with --help for more information.\n",
                       polydec::printable(first),
                       dash ? "; a file of that name is written with ./ before it, and a value "
                              "that begins with a minus as in --rhs=-x"
                            : "");
}

int run(int argc, char** argv) {
#ifdef POLYDEC_HAS_CHOLMOD
    polydec::register_cholmod();
#endif
#ifdef POLYDEC_HAS_PETSC
    polydec::register_petsc();
#endif
#ifdef POLYDEC_HAS_SLEPC
    polydec::register_slepc();
#endif
    CLI::App app{"polydec: discrete exterior calculus on the mesh you have", "polydec"};
    app.set_version_flag("--version", POLYDEC_VERSION);
    app.require_subcommand(1);
    app.failure_message(tell_misuse);
    app.footer("polydec COMMAND --help tells more and shows examples.\n"
               "Exit codes: 0 done, 1 wrong usage, 2 bad input, 3 numerical failure, 4 file or "
               "resource failure.");
    polydec::tools::add_info(app);
    polydec::tools::add_operators(app);
    polydec::tools::add_merge(app);
    polydec::tools::add_spectrum(app);
    polydec::tools::add_poisson(app);
    polydec::tools::add_distance(app);
    polydec::tools::add_generate(app);
    polydec::tools::add_reproduce(app);
    polydec::tools::add_backends(app);
    polydec::tools::expect_values(app);
    try {
        polydec::tools::reworded(polydec::tools::told, [&] { app.parse(argc, argv); });
    } catch (const CLI::ParseError& error) {
        return polydec::tell_usage(app, error);
    }
    return polydec::done;
}

} // namespace

int main(int argc, char** argv) {
    return polydec::run_process("polydec", run, argc, argv);
}
