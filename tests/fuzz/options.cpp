// SPDX-License-Identifier: MIT
#include "tests/fuzz/targets.h"
#include "tools/command_line.h"
#include "tools/expression.h"

#include <algorithm>
#include <optional>
#include <sstream>
#include <vector>

namespace polydec::fuzz {

namespace {

/// The words between line breaks, the last one first as the parser takes them.
std::vector<std::string> words(std::string_view bytes) {
    std::vector<std::string> result;
    std::istringstream lines{std::string(bytes)};
    for (std::string line; std::getline(lines, line);)
        result.push_back(line);
    std::reverse(result.begin(), result.end());
    return result;
}

} // namespace

/// Arguments of the command, one a line. They are understood or refused, and nothing is done.
void options(std::string_view bytes) {
    // built once: it forgets what it has parsed, and building takes a hundred times as long
    static const auto app = [] {
        auto made = tools::command_line();
        made->parse_complete_callback([] { throw CLI::Success(); }); // before any subcommand works
        return made;
    }();
    try {
        app->parse(words(bytes));
        throw Finding("nothing is understood without a subcommand");
    } catch (const CLI::ParseError& error) {
        std::ostringstream out, complaint;
        if (app->exit(error, out, complaint) != 0)
            require_message(complaint.str());
    }
}

/// An expression of the position. Its values are finite and do not hang on the other places.
void expression(std::string_view bytes) {
    std::optional<tools::Expression> expression;
    if (!accepts<CLI::ValidationError>([&] { expression.emplace("-f", std::string(bytes)); }))
        return;
    Points sites(4, 3);
    sites << 0, 0, 0, 1, 2, 3, -0.5, 1e-3, 7, 1e3, -1e-8, 0.25;
    accepts<CLI::ValidationError>([&] {
        accepts([&] {
            const Vector values = (*expression)(sites);
            require(values.allFinite(), "values are finite");
            const Vector turned = (*expression)(sites.colwise().reverse());
            require(values == turned.reverse(), "a value hangs on its place alone");
        });
    });
}

} // namespace polydec::fuzz
