// SPDX-License-Identifier: MIT
#pragma once

namespace polydec::paper {

/// The program of one reproduction: prints its tables, and writes its files if a folder is given.
/// Returns the exit code: 0 done, 1 wrong usage, 2 bad input, 3 numerical failure, 4 file or
/// resource failure. Never throws.
int run_program(const char* reproduction, int argc, char** argv);

} // namespace polydec::paper
