// SPDX-License-Identifier: MIT
#include "base/printable.h"
#include "examples/paper/report.h"
#include "examples/paper/reproductions.h"
#include "tools/commands.h"
#include "tools/common.h"
#include "tools/options.h"
#include "tools/outputs.h"

#include <fmt/format.h>

#include <memory>

namespace polydec::tools {

namespace {

using paper::Reproduction;

struct ReproduceArguments {
    std::string name;
    paper::Request request;
    std::filesystem::path out;
    bool list = false;
    TellOptions tell;
};

std::string check_name(const std::string& name) {
    std::string known;
    for (const auto& each : paper::reproductions()) {
        if (each.name == name)
            return "";
        known += each.name + ", ";
    }
    return name == "all" ? "" : fmt::format("there is no '{}'; expected {}or all", name, known);
}

std::string check_levels(const std::string& text) {
    const bool good = CLI::Range(1, 20)(text).empty();
    return good ? "" : fmt::format("expected a number from 1 to 20, not '{}'", text);
}

struct List : Answer {
    void write(JsonWriter& json) const override {
        json.array("reproductions", [&] {
            for (const auto& each : paper::reproductions())
                json.object([&] {
                    json.member("name", each.name);
                    json.member("summary", each.summary);
                });
        });
    }

    void write(Text& text) const override {
        for (const auto& each : paper::reproductions())
            text("{:<9} {}\n", each.name, each.summary);
    }
};

/// What was made, one or all, and where its files are.
struct Reports : Answer {
    struct Made {
        paper::Report report;
        std::vector<std::filesystem::path> files;
    };
    std::vector<Made> made;
    bool all = false;

    void write(JsonWriter& json) const override {
        if (!all)
            return paper::write(json, made.front().report);
        json.array("reports", [&] {
            for (const auto& each : made)
                json.object([&] { paper::write(json, each.report); });
        });
    }

    void write(Text& text) const override {
        const char* separator = "";
        for (const auto& [report, files] : made) {
            text("{}{}", separator, paper::to_text(report));
            for (const auto& file : files)
                text("{}\n", printable(file.string()));
            separator = "\n";
        }
    }
};

paper::Report make(const Reproduction& reproduction, paper::Request request) {
    const Progress progress;
    request.progress = [&](std::string_view what) {
        progress(fmt::format("{}: {}", reproduction.name, what));
    };
    request.progress("begins");
    return reproduction.run(request);
}

void run_reproduce(const ReproduceArguments& arguments) {
    Log log;
    if (arguments.list)
        return tell(List(), log, arguments.tell);
    if (!arguments.out.empty())
        check_output_folder(arguments.out);
    Reports answer;
    answer.all = arguments.name == "all";
    for (const auto& each : paper::reproductions()) {
        if (arguments.name != each.name && !answer.all)
            continue;
        auto& [report, files] = answer.made.emplace_back();
        report = make(each, arguments.request);
        if (!arguments.out.empty())
            files = paper::write_report(arguments.out, report);
    }
    tell(answer, log, arguments.tell);
}

} // namespace

void add_reproduce(CLI::App& app) {
    auto* command =
        app.add_subcommand("reproduce", "figures and tables of the paper, made with this library");
    const auto arguments = std::make_shared<ReproduceArguments>();
    auto* name = command->add_option("NAME", arguments->name, "which (see --list), or all");
    name->check(check_name);
    auto* list = command->add_flag("--list", arguments->list, "tell the names and end");
    list->excludes(name);
    command
        ->add_option("--levels", arguments->request.levels,
                     "refinements (default: as many as the figure has)")
        ->check(check_levels);
    command->add_option("--out", arguments->out,
                        "folder for .json, .csv and .svg files (default: print only)");
    command->add_option("--meshes", arguments->request.meshes,
                        "folder of mesh files for table2 (default: generated meshes)");
    add_common_options(*command, arguments->tell);
    command->footer("Examples:\n  polydec reproduce --list\n"
                    "  polydec reproduce fig7 --levels 4 --out figures\n"
                    "  polydec reproduce table2 --meshes models\n"
                    "  polydec reproduce all --out figures");
    command->callback([arguments] {
        if (arguments->name.empty() && !arguments->list)
            throw CLI::RequiredError("NAME");
        run_reproduce(*arguments);
    });
}

} // namespace polydec::tools
