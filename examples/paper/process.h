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

/// The main function of programs in this folder and in tools/. Returns the exit code of `work`, or
/// of the error that `work` throws, and prints its text to standard error after the program's name.
/// No unfinished file remains (system/unfinished.h) however the program ends: by a signal, by a
/// library that calls exit(), or by an error that cannot be passed on. A signal ends the program
/// unless it was ignored before. A broken pipe is an ordinary error. Allocates no memory once
/// memory is short. Threads wait passively unless OMP_WAIT_POLICY says otherwise.
int run_process(const char* name, int (*work)(int, char**), int argc, char** argv) noexcept;

/// Limits memory for cases that no check_memory foresees: the program ends with resource_failure
/// soon after it takes memory_limit() bytes more than at this call.
void hold_memory_limit();

} // namespace polydec
