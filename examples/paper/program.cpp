// SPDX-License-Identifier: MIT
#include "examples/paper/program.h"

#include "base/errors.h"
#include "examples/paper/console.h"
#include "examples/paper/process.h"
#include "examples/paper/reproductions.h"
#include "examples/paper/usage.h"

#include <CLI/CLI.hpp>

namespace polydec::paper {

namespace {

const Reproduction* chosen = nullptr;

int run(int argc, char** argv) {
    if (chosen == nullptr)
        throw InvalidInput("there is no reproduction of this name");
    const Reproduction& reproduction = *chosen;
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
        return tell_usage(app, error);
    }
    const Report report = reproduction.run(request);
    console::print("{}", to_text(report));
    if (!out.empty())
        for (const auto& file : write_report(out, report))
            console::print("{}\n", file.string());
    return done;
}

} // namespace

int run_program(const char* reproduction, int argc, char** argv) {
    chosen = nullptr;
    for (const auto& each : reproductions())
        if (each.name == reproduction)
            chosen = &each;
    return run_process(reproduction, run, argc, argv);
}

} // namespace polydec::paper
