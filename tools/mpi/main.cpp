// SPDX-License-Identifier: MIT
#include "examples/paper/console.h"
#include "examples/paper/process.h"
#include "examples/paper/usage.h"
#include "tools/command_line.h"
#include "tools/messages.h"
#include "tools/mpi/commands.h"
#include "tools/options.h"

#include <fmt/format.h>

namespace {

using polydec::Ranks;

/// Commands of polydec that are not there for several ranks are refused by name.
void refuse_others(CLI::App& app) {
    for (const char* name : {"view", "draw", "hodge", "heat", "wave", "flow", "distance",
                             "generate", "reproduce", "backends"}) {
        auto* command = app.add_subcommand(name, "")->group("")->prefix_command();
        command->parse_complete_callback(
            [name] { throw polydec::tools::OneProcessOnly(name, name); });
    }
}

std::unique_ptr<CLI::App> command_line(const Ranks& ranks) {
    auto app = polydec::tools::empty_command_line(
        "polydec-mpi", "discrete exterior calculus over several processes, by MPI");
    using namespace polydec::tools;
    for (const auto add : {add_shared_info, add_shared_merge, add_shared_operators,
                           add_shared_poisson, add_shared_spectrum, add_convert})
        add(*app, ranks);
    polydec::tools::expect_values(*app);
    refuse_others(*app);
    return app;
}

/// An error that has come to this rank alone leaves the others waiting.
void end_all(const Ranks& ranks) {
    std::string text = "an unknown error";
    try {
        throw;
    } catch (const std::exception& error) {
        text = error.what();
    } catch (...) {
    }
    polydec::console::be_silent(false);
    polydec::console::tell(
        fmt::format("polydec-mpi: only rank {} failed: {}\n", ranks.rank(), text));
    ranks.abort(polydec::resource_failure);
}

int run(int argc, char** argv) {
    const Ranks ranks = Ranks::all();
    polydec::console::be_silent(ranks.rank() != 0); // they all say the same
    const auto app = command_line(ranks);
    try {
        polydec::tools::reworded(polydec::tools::told, [&] { app->parse(argc, argv); });
    } catch (const CLI::ParseError& error) {
        return polydec::tell_usage(*app, error);
    } catch (...) {
        constexpr double patience = 10; // seconds
        if (!ranks.all_come(patience))
            end_all(ranks);
        throw;
    }
    return polydec::done;
}

} // namespace

int main(int argc, char** argv) {
    return polydec::run_process("polydec-mpi", run, argc, argv);
}
