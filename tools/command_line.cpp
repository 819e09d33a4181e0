// SPDX-License-Identifier: MIT
#include "tools/command_line.h"

#include "base/did_you_mean.h"
#include "base/printable.h"
#include "tools/commands.h"
#include "tools/help.h"
#include "tools/messages.h"
#include "tools/options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string>
#include <vector>

namespace polydec::tools {

namespace {

constexpr const char* one_process_only = "OneProcessOnly";

using Names = std::vector<std::string>;

/// An argument that this command does not know.
std::string unknown(const CLI::App& app, const std::string& argument) {
    const auto shown = printable(argument);
    if (argument.size() > 1 && argument[0] == '-' && argument[1] != '-')
        return fmt::format("{} has no option '{}'; write ./ before a file of that name, and "
                           "--rhs=-x for a value that begins with a minus sign",
                           app.get_name(), shown);
    if (argument.substr(0, 2) == "--") {
        Names names;
        for (const auto* option : app.get_options())
            if (!option->get_positional() && !option->get_group().empty())
                names.push_back(option->get_name());
        return fmt::format("{} has no option '{}'{}", app.get_name(), shown,
                           did_you_mean(argument.substr(0, argument.find('=')), names));
    }
    if (const auto names = commands_of(app); !names.empty())
        return fmt::format("there is no command '{}'{}", shown, did_you_mean(argument, names));
    return fmt::format("{} expects no further argument '{}'", app.get_name(), shown);
}

/// All that this command needs and was not given.
std::string missing(const CLI::App& app) {
    Names needed;
    for (const auto* option : app.get_options())
        if (option->get_required() && option->count() == 0) {
            const auto text = description_of(*option);
            needed.insert(option->get_positional() ? needed.begin() : needed.end(),
                          fmt::format("{} ({})", with_value(*option),
                                      text.substr(0, text.find_first_of(":;("))));
        }
    if (app.get_require_subcommand_min() > 0 && app.get_subcommands().empty())
        return fmt::format("expected a command: {}", fmt::join(commands_of(app), ", "));
    return fmt::format("{} needs {}", app.get_name(), fmt::join(needed, " and "));
}

/// An unknown argument is the cause even where something is missing too.
std::string tell_misuse(const CLI::App* app, const CLI::Error& error) {
    std::string message = error.what();
    const auto* active = app;
    const bool is_unknown = !app->remaining(true).empty();
    while (!active->get_subcommands().empty() && !(is_unknown && !active->remaining().empty()))
        active = active->get_subcommands().front();
    const auto kind = error.get_name();
    if (is_unknown && kind != one_process_only)
        message = unknown(*active, active->remaining().front());
    else if (kind == "ArgumentMismatch") // its own message names the type of the values
        message = message.substr(0, message.find(':')) + ": expected another number of values";
    else if (kind == "RequiredError") // its own message names the first option only
        message = missing(*active);
    return fmt::format("{}: {}\nRun with --help for more information.\n", app->get_name(),
                       told(message));
}

} // namespace

OneProcessOnly::OneProcessOnly(const std::string& what, const std::string& command)
    : ParseError(one_process_only,
                 fmt::format("{} runs in one process only: polydec {}", what, command),
                 CLI::ExitCodes::ValidationError) {}

std::unique_ptr<CLI::App> empty_command_line(const std::string& name,
                                             const std::string& description) {
    auto app = std::make_unique<CLI::App>(description, name);
    app->formatter(std::make_shared<Help>());
    app->group("Commands");
    app->option_defaults()->always_capture_default();
    app->set_help_flag("-h,--help", "print this help");
    app->set_version_flag("--version", POLYDEC_VERSION, "print the version");
    app->require_subcommand(1);
    app->failure_message(tell_misuse);
    app->footer("\n" + name +
                " COMMAND --help lists the options of a command and shows examples.\nExit codes: 0 "
                "done, 1 wrong usage, 2 bad input, 3 numerical failure, 4 file or resource "
                "failure.");
    return app;
}

std::unique_ptr<CLI::App> command_line() {
    auto app = empty_command_line("polydec", "discrete exterior calculus on the mesh you have");
    for (const auto add : {add_info, add_operators, add_merge, add_view, add_draw, add_spectrum,
                           add_poisson, add_hodge, add_heat, add_wave, add_maxwell, add_flow,
                           add_distance, add_generate, add_reproduce, add_backends})
        add(*app);
    expect_values(*app);
    return app;
}

} // namespace polydec::tools
