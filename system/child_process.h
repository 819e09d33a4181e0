// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace polydec {

/// Limits at which a child program is stopped.
struct ChildLimits {
    double seconds = 300.0;
    std::size_t bytes = std::size_t{8} << 30;        ///< of address space, and of each file
    std::size_t output_bytes = std::size_t{1} << 20; ///< kept of its output; the rest is dropped
};

/// How a program ended: by itself, by a signal, by timeout, or because this program received a
/// request to end (held_signals.h).
enum class ChildEnd { exited, signaled, timed_out, interrupted };

struct ChildOutcome {
    ChildEnd end = ChildEnd::exited;
    int code = 0;               ///< exit code, or the signal's number
    std::string output = {};    ///< standard output and standard error, interleaved as written
    std::size_t peak_bytes = 0; ///< peak memory; 0 if not more than this program itself
};

/// The first executable file of this name in the folders of PATH.
std::optional<std::filesystem::path> find_program(const std::string& name);

/// Runs a program in a folder, without a shell, and waits for its end. It has no input, leaves no
/// core file, and leads a process group that is killed as a whole. All its children are gone when
/// this function returns and, on Linux, when this program is killed.
/// Throws IoError, naming the program and the system's reason, if it cannot be started.
ChildOutcome run_child(const std::filesystem::path& program,
                       const std::vector<std::string>& arguments,
                       const std::filesystem::path& folder, const ChildLimits& limits = {});

} // namespace polydec
