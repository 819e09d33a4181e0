// SPDX-License-Identifier: MIT
#pragma once

#include "base/errors.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace polydec {

/// Memory available to this program, in bytes, as far as the system reports it: the machine's
/// memory, or a lower limit on the process or on one of its control groups.
std::uint64_t machine_memory();

/// The most memory that this process has used so far, in bytes.
std::int64_t peak_memory();

/// Limit for check_memory, initially machine_memory(). Applies to the whole program.
std::uint64_t memory_limit();
void set_memory_limit(std::uint64_t bytes);

/// For the main function of a program that allocates large arrays one after the other: freed memory
/// stays with the program for reuse. By default the C library returns large blocks, and the system
/// clears each new one, which on virtual machines takes seconds per GB. Requires glibc; affects
/// later allocations.
void keep_freed_memory();

/// An engine needs more memory than is available: the text names the engine.
class OutOfMemory : public SolverFailure {
public:
    using SolverFailure::SolverFailure;
};

/// "`what` needs about .. of memory, but the limit is .." if a size exceeds the limit; else empty.
std::string lack_of_memory(double bytes, std::string_view what);

/// Call before an allocation whose size follows from a few numbers of the input. Throws IoError,
/// naming `what` ("a complex of ..") and both amounts, if the size exceeds the limit.
void check_memory(double bytes, std::string_view what);

} // namespace polydec
