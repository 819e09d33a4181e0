// SPDX-License-Identifier: MIT
#include "examples/paper/usage.h"

#include "examples/paper/console.h"
#include "examples/paper/process.h"

#include <CLI/CLI.hpp>

#include <new>
#include <sstream>

namespace polydec {

int tell_usage(const CLI::App& app, const CLI::ParseError& error) {
    std::ostringstream help, complaint;
    const bool asked_for = app.exit(error, help, complaint) == 0;
    if (!help || !complaint)
        throw std::bad_alloc(); // a stream keeps it to itself
    console::write(help.str());
    console::tell(complaint.str());
    return asked_for ? done : wrong_usage;
}

} // namespace polydec
