// SPDX-License-Identifier: MIT
#include "examples/paper/console.h"
#include "examples/paper/process.h"
#include "examples/paper/usage.h"
#include "tools/command_line.h"
#include "tools/describe.h"
#include "tools/joining.h"
#include "tools/messages.h"
#include "tools/picture.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace {

int run(int argc, char** argv) {
    polydec::tools::set_command_text(argc, argv);
    const auto app = polydec::tools::command_line();
    if (argc == 2 && std::string_view(argv[1]) == "--describe") { // no option: for scripts only
        polydec::console::write(polydec::tools::description(*app));
        return polydec::done;
    }
    auto words = polydec::tools::words_of(argc, argv);
    std::reverse(words.begin(), words.end()); // as the parser takes them
    try {
        polydec::tools::reworded(polydec::tools::told, [&] { app->parse(std::move(words)); });
    } catch (const CLI::ParseError& error) {
        return polydec::tell_usage(*app, error);
    }
    return polydec::done;
}

} // namespace

int main(int argc, char** argv) {
    return polydec::run_process("polydec", run, argc, argv);
}
