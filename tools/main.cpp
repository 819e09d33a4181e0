// SPDX-License-Identifier: MIT
#include "examples/paper/process.h"
#include "examples/paper/usage.h"
#include "tools/command_line.h"
#include "tools/messages.h"
#ifdef POLYDEC_HAS_CHOLMOD
#include "backends/cholmod.h"
#endif
#ifdef POLYDEC_HAS_PETSC
#include "backends/petsc.h"
#endif
#ifdef POLYDEC_HAS_SLEPC
#include "backends/slepc.h"
#endif

namespace {

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
    const auto app = polydec::tools::command_line();
    try {
        polydec::tools::reworded(polydec::tools::told, [&] { app->parse(argc, argv); });
    } catch (const CLI::ParseError& error) {
        return polydec::tell_usage(*app, error);
    }
    return polydec::done;
}

} // namespace

int main(int argc, char** argv) {
    return polydec::run_process("polydec", run, argc, argv);
}
