// SPDX-License-Identifier: MIT
#include "base/printable.h"
#include "examples/paper/report.h"
#include "examples/paper/reproductions.h"
#include "tools/commands.h"
#include "tools/common.h"
#include "tools/outputs.h"

#include <fmt/format.h>

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

std::vector<std::string> names() {
    std::vector<std::string> names;
    for (const auto& each : paper::reproductions())
        names.push_back(each.name);
    names.emplace_back("all");
    return names;
}

std::string check_levels(const std::string& text) {
    const bool good = CLI::Range(1, 20)(text).empty();
    return good ? "" : fmt::format("expected a number from 1 to 20, not '{}'", text);
}

struct List {
    void write(JsonWriter& json) const {
        json.objects("reproductions", paper::reproductions(), [&](const auto& each) {
            json.member("name", each.name);
            json.member("summary", each.summary);
        });
    }

    void write(Text& text) const {
        for (const auto& each : paper::reproductions())
            text("{:<9} {}\n", each.name, each.summary);
    }
};

/// What was made, one or all, and where its files are.
struct Reports {
    struct Made {
        paper::Report report;
        std::vector<std::filesystem::path> files;
    };
    std::vector<Made> made;
    bool all = false;

    void write(JsonWriter& json) const {
        if (!all)
            return paper::write(json, made.front().report);
        json.objects("reports", made, [&](const auto& each) { paper::write(json, each.report); });
    }

    void write(Text& text) const {
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
    const ProgressLine progress;
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
    if (arguments.name.empty())
        throw CLI::ValidationError("NAME", one_of(names())("") + "; see --list");
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
    const auto [command, arguments] = add_command<ReproduceArguments>(
        app, "reproduce", "reproduces the figures and tables of the paper", run_reproduce);
    auto* name = command->add_option("NAME", arguments->name, "name from --list, or all");
    name->check(one_of(names()));
    auto* list = command->add_flag("--list", arguments->list, "print the names");
    command
        ->add_option("--levels", arguments->request.levels,
                     "N\trefinements (default: as in the figure)")
        ->check(check_levels);
    command->add_option("--out", arguments->out,
                        "FOLDER\tfolder for .json, .csv and .svg files (default: print only)");
    command->add_option("--meshes", arguments->request.meshes,
                        "FOLDER\tmesh files for table2 (default: generated meshes)");
    list->excludes(name)->excludes("--levels")->excludes("--out")->excludes("--meshes");
    add_common_options(*command, arguments->tell);
    command->footer("Examples:\n  polydec reproduce --list\n"
                    "  polydec reproduce fig7 --levels 4 --out figures\n"
                    "  polydec reproduce table2 --meshes models\n"
                    "  polydec reproduce all --out figures");
}

} // namespace polydec::tools
