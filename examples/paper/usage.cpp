// SPDX-License-Identifier: MIT
#include "examples/paper/usage.h"

#include "examples/paper/console.h"
#include "examples/paper/process.h"

#include <CLI/CLI.hpp>

#include <new>
#include <sstream>
#include <string>

namespace polydec {

namespace {

struct Usage {
    std::string help, complaint;
    bool is_asked_for;
    bool operator==(const Usage&) const = default;
};

Usage usage(const CLI::App& app, const CLI::ParseError& error) {
    std::ostringstream help, complaint;
    const bool is_asked_for = app.exit(error, help, complaint) == 0;
    if (!help || !complaint)
        throw std::bad_alloc(); // a stream swallows the exception
    return {help.str(), complaint.str(), is_asked_for};
}

} // namespace

int tell_usage(const CLI::App& app, const CLI::ParseError& error) {
    const auto told = usage(app, error);
    if (told != usage(app, error))
        throw std::bad_alloc(); // as do streams inside the library, and their text then has gaps
    console::write(told.help);
    console::tell(told.complaint);
    return told.is_asked_for ? done : wrong_usage;
}

} // namespace polydec
