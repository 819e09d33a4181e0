// SPDX-License-Identifier: MIT
#include "tools/command_line.h"

#include "base/printable.h"
#include "tools/commands.h"
#include "tools/messages.h"
#include "tools/options.h"

#include <fmt/format.h>

#include <string>

namespace polydec::tools {

namespace {

constexpr const char* one_process_only = "OneProcessOnly";

/// An argument that nobody knows is the cause even where something is missing too.
std::string tell_misuse(const CLI::App* app, const CLI::Error& error) {
    const auto unknown = app->remaining(true);
    if (unknown.empty() || error.get_name() == one_process_only)
        return fmt::format("{}: {}\nRun with --help for more information.\n", app->get_name(),
                           told(error.what()));
    const auto& first = unknown.front();
    const bool dash = first.size() > 1 && first[0] == '-' && first[1] != '-';
    return fmt::format("{}: there is no '{}' here{}\nRun with --help for more information.\n",
                       app->get_name(), printable(first),
                       dash ? "; a file of that name is written with ./ before it, and a value "
                              "that begins with a minus as in --rhs=-x"
                            : "");
}

} // namespace

OneProcessOnly::OneProcessOnly(const std::string& what, const std::string& command)
    : ParseError(one_process_only,
                 fmt::format("{} runs in one process only: polydec {}", what, command),
                 CLI::ExitCodes::ValidationError) {}

std::unique_ptr<CLI::App> empty_command_line(const std::string& name,
                                             const std::string& description) {
    auto app = std::make_unique<CLI::App>(name + ": " + description, name);
    app->set_version_flag("--version", POLYDEC_VERSION);
    app->require_subcommand(1);
    app->failure_message(tell_misuse);
    app->footer(name + " COMMAND --help tells more and shows examples.\n"
                       "Exit codes: 0 done, 1 wrong usage, 2 bad input, 3 numerical failure, 4 "
                       "file or resource failure.");
    return app;
}

std::unique_ptr<CLI::App> command_line() {
    auto app = empty_command_line("polydec", "discrete exterior calculus on the mesh you have");
    add_info(*app);
    add_operators(*app);
    add_merge(*app);
    add_view(*app);
    add_draw(*app);
    add_spectrum(*app);
    add_poisson(*app);
    add_hodge(*app);
    add_heat(*app);
    add_wave(*app);
    add_maxwell(*app);
    add_flow(*app);
    add_distance(*app);
    add_generate(*app);
    add_reproduce(*app);
    add_backends(*app);
    expect_values(*app);
    return app;
}

} // namespace polydec::tools
