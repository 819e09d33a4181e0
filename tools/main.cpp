// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "io/atomic_file.h"
#include "tools/commands.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <unistd.h>

namespace {

enum ExitCode { wrong_usage = 1, bad_input = 2, numerical_failure = 3, resource_failure = 4 };

extern "C" void clean_up_and_die(int signal) {
    polydec::remove_unfinished_files();
    _exit(128 + signal);
}

int fail(ExitCode code, const char* text) {
    fmt::print(stderr, "polydec: {}\n", text);
    return code;
}

/// An argument that nobody knows is the cause even where something is missing too.
std::string tell_misuse(const CLI::App* app, const CLI::Error& error) {
    const auto unknown = app->remaining(true);
    const auto what = unknown.empty() ? std::string(error.what())
                                      : fmt::format("there is no '{}' here", unknown.front());
    return fmt::format("polydec: {}\nRun with --help for more information.\n", what);
}

int run(int argc, char** argv) {
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
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : wrong_usage;
    }
    // output that could not be written is no success
    return std::fflush(stdout) == 0 ? 0 : fail(resource_failure, "standard output is not writable");
}

} // namespace

int main(int argc, char** argv) {
    std::signal(SIGINT, clean_up_and_die);
    std::signal(SIGTERM, clean_up_and_die);
    try {
        return run(argc, argv);
    } catch (const polydec::InvalidInput& error) {
        return fail(bad_input, error.what());
    } catch (const polydec::SolverFailure& error) {
        return fail(numerical_failure, error.what());
    } catch (const std::bad_alloc&) {
        return fail(resource_failure, "memory does not suffice for this mesh");
    } catch (const std::exception& error) {
        return fail(resource_failure, error.what());
    }
}
