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

/// An engine needs more memory than it can get: the text names the engine.
class OutOfMemory : public SolverFailure {
public:
    using SolverFailure::SolverFailure;
};

/// To be called before memory is asked for whose amount follows from a few numbers of the input.
/// Throws IoError, naming `what` ("a complex of ..") and both amounts, if that is above the limit.
void check_memory(double bytes, std::string_view what);

} // namespace polydec
