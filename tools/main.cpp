// SPDX-License-Identifier: MIT
#include "examples/paper/process.h"
#include "examples/paper/usage.h"
#include "tools/command_line.h"
#include "tools/messages.h"
#include "tools/picture.h"

namespace {

int run(int argc, char** argv) {
    polydec::tools::set_command_text(argc, argv);
    const auto app = polydec::tools::command_line();
    try {
        polydec::tools::reworded(polydec::tools::told, [&] { app->parse(argc, argv); });
    } catch (const CLI::ParseError& error) {
        return polydec::tell_usage(*app, error);
    }
    return polydec::done;
}

} // namespace

int main(int argc, char** argv) {
    return polydec::run_process("polydec", run, argc, argv);
}
