// SPDX-License-Identifier: MIT
#pragma once

#include "base/errors.h"

#include <cstdint>
#include <string_view>

namespace polydec {

/// The bytes of memory that this program may have at most, as far as the system tells: the
/// machine's, or less where the process or one of the control groups it is in is limited.
std::uint64_t machine_memory();

/// What check_memory compares with, machine_memory() at first. Holds for the whole program.
std::uint64_t memory_limit();
void set_memory_limit(std::uint64_t bytes);

/// For the main of a program that makes large arrays one after the other: what is freed stays with
/// the program, to be used again. By default the C library gives large blocks back, and the system
/// has to clear each new one, which on virtual machines takes seconds for each GB. Takes effect
/// with glibc, on what is allocated from then on.
void keep_freed_memory();

/// An engine needs more memory than it can get: the text names the engine.
class OutOfMemory : public SolverFailure {
public:
    using SolverFailure::SolverFailure;
};

/// To be called before memory is asked for whose amount follows from a few numbers of the input.
/// Throws IoError, naming `what` ("a complex of ..") and both amounts, if that is above the limit.
void check_memory(double bytes, std::string_view what);

} // namespace polydec
