// SPDX-License-Identifier: MIT
#include "tools/describe.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string>
#include <vector>

namespace polydec::tools {

namespace {

std::string one_line(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c == '\n' || c == '\t'; }, ' ');
    return text;
}

std::string option_lines(const CLI::App& app, const std::string& path) {
    std::string lines;
    for (const CLI::Option* option : app.get_options()) {
        std::vector<std::string> names;
        for (const auto& name : option->get_lnames())
            names.push_back("--" + name);
        for (const auto& name : option->get_snames())
            names.push_back("-" + name);
        const bool is_hidden = option->get_group().empty();
        if (names.empty() || is_hidden)
            continue;
        lines += fmt::format("option\t{}\t{}\t{}\t{}\n", path, fmt::join(names, " "),
                             option->get_items_expected_max() > 0 ? 1 : 0,
                             one_line(option->get_description()));
    }
    return lines;
}

std::string lines_of(const CLI::App& app, const std::string& path) {
    std::string lines = option_lines(app, path);
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        const bool is_hidden = command->get_group().empty();
        if (is_hidden)
            continue;
        const auto own_path = path + (path.empty() ? "" : " ") + command->get_name();
        lines += fmt::format("command\t{}\t{}\n", own_path, one_line(command->get_description()));
        lines += lines_of(*command, own_path);
    }
    return lines;
}

} // namespace

std::string description(const CLI::App& app) {
    return lines_of(app, "");
}

} // namespace polydec::tools
