// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace polydec {

/// What a program may take before it is stopped.
struct ChildLimits {
    double seconds = 300.0;
    std::size_t bytes = std::size_t{8} << 30;        ///< of address space, and of each file
    std::size_t output_bytes = std::size_t{1} << 20; ///< kept of what it prints; the rest is lost
};

/// How a program ended: by itself, by a signal, because its time was over, or because this program
/// was asked to end (held_signals.h).
enum class ChildEnd { exited, signaled, timed_out, interrupted };

struct ChildOutcome {
    ChildEnd end = ChildEnd::exited;
    int code = 0;               ///< exit code, or the signal's number
    std::string output = {};    ///< standard output and standard error, as they came
    std::size_t peak_bytes = 0; ///< most memory it had; 0 if not more than this program itself
};

/// The first executable file of that name in the folders of PATH.
std::optional<std::filesystem::path> find_program(const std::string& name);

/// Runs a program in a folder, without a shell, and waits for its end. It reads nothing, leaves no
/// core file, and is the leader of a process group that is killed as a whole; whatever it started
/// is gone when this returns, as it is, on Linux, when this program is killed.
/// Throws IoError, naming the program and the system's reason, if it cannot be started.
ChildOutcome run_child(const std::filesystem::path& program,
                       const std::vector<std::string>& arguments,
                       const std::filesystem::path& folder, const ChildLimits& limits = {});

} // namespace polydec
