// SPDX-License-Identifier: MIT
#include "examples/paper/console.h"
#include "examples/paper/report.h"
#include "examples/paper/reproductions.h"
#include "tools/commands.h"
#include "tools/common.h"

#include <fmt/format.h>

#include <memory>

namespace polydec::tools {

namespace {

using paper::Reproduction;

struct Arguments {
    std::string name;
    paper::Request request;
    std::filesystem::path out;
    bool list = false;
    bool json = false;
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

void print_list(bool json) {
    Json list = Json::array();
    for (const auto& each : paper::reproductions()) {
        list.push_back({{"name", each.name}, {"summary", each.summary}});
        if (!json)
            console::print("{:<9} {}\n", each.name, each.summary);
    }
    if (json)
        console::print("{}\n", Json{{"reproductions", std::move(list)}}.dump());
}

paper::Report make(const Reproduction& reproduction, paper::Request request) {
    const Progress progress;
    request.progress = [&](std::string_view what) {
        progress(fmt::format("{}: {}", reproduction.name, what));
    };
    request.progress("begins");
    return reproduction.run(request);
}

void run(const Arguments& arguments) {
    if (arguments.list)
        return print_list(arguments.json);
    Json reports = Json::array();
    const char* separator = "";
    for (const auto& each : paper::reproductions()) {
        if (arguments.name != each.name && arguments.name != "all")
            continue;
        const auto report = make(each, arguments.request);
        if (!arguments.json)
            console::print("{}{}", separator, paper::to_text(report));
        else
            reports.push_back(Json::parse(paper::to_json(report)));
        console::flush(); // a figure that is done stays told if the next one fails
        separator = "\n";
        if (arguments.out.empty())
            continue;
        for (const auto& file : paper::write_report(arguments.out, report))
            if (!arguments.json)
                console::print("{}\n", file.string());
    }
    if (!arguments.json)
        return;
    if (arguments.name == "all")
        console::print("{}\n", Json{{"reports", std::move(reports)}}.dump());
    else
        console::print("{}\n", reports.front().dump());
}

} // namespace

void add_reproduce(CLI::App& app) {
    auto* command =
        app.add_subcommand("reproduce", "figures and tables of the paper, made with this library");
    const auto arguments = std::make_shared<Arguments>();
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
    command->add_flag("--json", arguments->json, "print one JSON object");
    command->footer("Examples:\n  polydec reproduce --list\n"
                    "  polydec reproduce fig7 --levels 4 --out figures\n"
                    "  polydec reproduce table2 --meshes models\n"
                    "  polydec reproduce all --out figures");
    command->callback([arguments] {
        if (arguments->name.empty() && !arguments->list)
            throw CLI::RequiredError("NAME");
        run(*arguments);
    });
}

} // namespace polydec::tools
