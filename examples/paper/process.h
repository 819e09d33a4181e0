// SPDX-License-Identifier: MIT
#pragma once

namespace polydec {

enum ExitCode {
    done = 0,
    wrong_usage = 1,
    bad_input = 2,
    numerical_failure = 3,
    resource_failure = 4
};

/// What a program of this folder or of tools/ does in its main function. Returns the exit code:
/// that of `work`, or that of the error it throws, whose text is told on standard error after the
/// program's name. Whatever ends the program leaves nothing behind that is unfinished
/// (base/unfinished.h): a signal, by which it ends unless it was ignored before, a library that
/// calls exit(), or an error where none can be passed on. A broken pipe is an error like any other.
/// Once memory is short, none is asked for.
int run_process(const char* name, int (*work)(int, char**), int argc, char** argv) noexcept;

/// From now on the program ends with resource_failure, as after an error, soon after it has taken
/// memory_limit() bytes more than it has now: what no check_memory has foreseen.
void hold_memory_limit();

} // namespace polydec
