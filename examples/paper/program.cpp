// SPDX-License-Identifier: MIT
#include "examples/paper/program.h"

#include "base/errors.h"
#include "examples/paper/reproductions.h"
#include "io/atomic_file.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>
#include <unistd.h>

namespace polydec::paper {

namespace {

enum ExitCode { wrong_usage = 1, bad_input = 2, numerical_failure = 3, resource_failure = 4 };

extern "C" void clean_up_and_die(int signal) {
    remove_unfinished_files();
    _exit(128 + signal);
}

int fail(const char* name, ExitCode code, const char* text) {
    fmt::print(stderr, "{}: {}\n", name, text);
    return code;
}

int run(const Reproduction& reproduction, int argc, char** argv) {
    CLI::App app{reproduction.summary, "paper_" + reproduction.name};
    Request request;
    std::filesystem::path out;
    app.add_option("--levels", request.levels, "refinements; 0: as many as the figure has")
        ->check(CLI::Range(0, 20));
    app.add_option("--out", out, "folder for .json, .csv and .svg files");
    app.add_option("--meshes", request.meshes, "folder of mesh files (table2)");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : wrong_usage;
    }
    const Report report = reproduction.run(request);
    fmt::print("{}", to_text(report));
    if (!out.empty())
        for (const auto& file : write_report(out, report))
            fmt::print("{}\n", file.string());
    const bool printed = std::fflush(stdout) == 0;
    return printed ? 0
                   : fail(reproduction.name.c_str(), resource_failure,
                          "standard output is not writable");
}

} // namespace

int run_program(const char* reproduction, int argc, char** argv) {
    std::signal(SIGINT, clean_up_and_die);
    std::signal(SIGTERM, clean_up_and_die);
    try {
        const auto& all = reproductions();
        const auto found = std::find_if(all.begin(), all.end(), [&](const Reproduction& each) {
            return each.name == reproduction;
        });
        if (found == all.end())
            return fail(reproduction, wrong_usage, "there is no such reproduction");
        return run(*found, argc, argv);
    } catch (const InvalidInput& error) {
        return fail(reproduction, bad_input, error.what());
    } catch (const SolverFailure& error) {
        return fail(reproduction, numerical_failure, error.what());
    } catch (const std::exception& error) {
        return fail(reproduction, resource_failure, error.what());
    }
}

} // namespace polydec::paper
