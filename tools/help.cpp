// SPDX-License-Identifier: MIT
#include "tools/help.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

namespace polydec::tools {

namespace {

constexpr std::size_t width = 100, column = 22;

struct Group {
    std::string_view title, options;
};

/// In reading order. The first group has the options that no other has.
constexpr std::array groups{
    Group{"Options", ""},
    Group{"Options", " --engine --eigen-engine --max-memory "},
    Group{"Options", " --help --version "},
    Group{"Mesh", " MESH --tolerance --angle-tolerance --no-merge --keep-groups --periodic --glue "
                  "--weld --join-hanging --peel --refine --delaunay --owners "},
    Group{"Star", " --star --centers "},
    Group{"Boundary", " --natural --essential-where --essential-on --boundary --boundary-values "
                      "--boundary-velocity --flux --robin --fixed-where --no-slip-where "
                      "--no-slip-on --open-where --open-on --absorb --layer "},
    Group{"Time", " --until --time-step --integrator --scheme --tolerance-in-time "},
    Group{"Output",
          " --out --up --length-unit --float32 --isolines --frames --checkpoint --resume "},
    Group{"Output", " --json --timing "}};

const Group& group_of(const CLI::Option& option) {
    const auto* const found = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
        return group.options.find(" " + option.get_name() + " ") != std::string_view::npos;
    });
    return found == groups.end() ? groups.front() : *found;
}

/// The name of the value, and what the option does.
std::pair<std::string, std::string> parts(const CLI::Option& option) {
    const std::string& text = option.get_description();
    const auto tab = text.find('\t');
    return tab == std::string::npos ? std::pair(std::string(), text)
                                    : std::pair(text.substr(0, tab), text.substr(tab + 1));
}

std::vector<const CLI::App*> listed_commands(const CLI::App& app) {
    return app.get_subcommands([](const CLI::App* each) { return !each->get_group().empty(); });
}

/// What values with these names are.
constexpr std::array kinds{
    std::pair{"EXPR", "expression in x, y, z, or a file of numbers, one per vertex, facet or cell"},
    std::pair{"FORM", "an EXPR; coefficients of dx, dy, .. or dx dy, ..: '-y; x; 0'; or a file"}};

/// The text in lines, the first of which begins at a column, the others at an indentation.
std::string wrapped(std::string_view text, std::size_t at, std::size_t indentation) {
    std::string lines;
    for (;;) {
        const auto fitting = text.substr(0, width - at + 1);
        auto end = fitting.find('\n');
        if (end == std::string_view::npos && fitting.size() + at > width)
            end = fitting.rfind(' ');
        if (end == std::string_view::npos)
            return lines += text;
        lines += fmt::format("{}\n{:{}}", text.substr(0, end), "", indentation);
        text.remove_prefix(end + 1);
        at = indentation;
    }
}

std::string row(const std::string& name, const std::string& text) {
    const auto begin = fmt::format("  {:<{}}  ", name, column - 4);
    return begin + wrapped(text, begin.size(), column) + "\n";
}

/// With what follows from the option: whether it is required, and its default.
std::string row(const CLI::Option& option) {
    std::string name = with_value(option), text = description_of(option);
    if (const auto& letters = option.get_snames(); !letters.empty())
        name = fmt::format("-{}, {}", letters.front(), name);
    if (option.get_required() && !option.get_positional())
        text += " (required)";
    std::string preset = option.get_default_str();
    std::erase_if(preset, [](char c) { return c == '[' || c == ']' || c == '"'; });
    if (!preset.empty() && preset != "0" && text.find("(default") == std::string::npos)
        text += fmt::format(" (default: {})", preset);
    return row(name, text);
}

std::string usage(const CLI::App& app, const std::string& name) {
    std::string line = "Usage: " + name;
    if (!listed_commands(app).empty())
        line += app.get_parent() == nullptr ? " COMMAND" : " [NAME]";
    for (const auto* option : app.get_options())
        if (option->get_positional())
            line += option->get_required() ? " " + option->get_name()
                                           : fmt::format(" [{}]", option->get_name());
    for (const auto* option : app.get_options())
        if (option->get_required() && !option->get_positional())
            line += " " + with_value(*option);
    return line + " [OPTIONS]\n";
}

} // namespace

std::vector<std::string> commands_of(const CLI::App& app) {
    std::vector<std::string> names;
    for (const auto* each : listed_commands(app))
        names.push_back(each->get_name());
    return names;
}

std::string with_value(const CLI::Option& option) {
    const auto value = parts(option).first;
    return option.get_name() + (value.empty() || value.rfind("[=", 0) == 0 ? "" : " ") + value;
}

std::string description_of(const CLI::Option& option) {
    return parts(option).second;
}

std::string Help::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode) const {
    std::string help = wrapped(fmt::format("{}: {}", name, app->get_description()), 0, 0);
    help += "\n" + usage(*app, name);
    std::string_view title;
    const auto add = [&](std::string_view group, const std::string& line) {
        if (group != title)
            help += fmt::format("{}:\n", title = group);
        help += line;
    };
    const auto options = app->get_options([&](const CLI::Option* option) {
        const bool is_help = app->get_parent() != nullptr && option == app->get_help_ptr();
        return !option->get_group().empty() && !is_help; // of a command, which has just been used
    });
    for (const Group& group : groups)
        for (const auto* option : options)
            if (&group_of(*option) == &group)
                add(group.title, row(*option));
    for (const auto* command : listed_commands(*app))
        add(command->get_group(), row(command->get_name(), command->get_description()));
    for (const auto& kind : kinds)
        if (std::any_of(options.begin(), options.end(),
                        [&](const auto* option) { return parts(*option).first == kind.first; }))
            add("Expressions", row(kind.first, kind.second));
    return help + wrapped(app->get_footer(), 0, 0) + "\n";
}

} // namespace polydec::tools
