// SPDX-License-Identifier: MIT
#pragma once

#include <csignal>
#include <cstddef>

namespace polydec {

/// The signals that ask a program to end, and end it unless it says otherwise.
inline constexpr int ending_signals[] = {SIGHUP, SIGINT, SIGQUIT, SIGTERM, SIGXCPU, SIGXFSZ};

/// A file, a folder or a group of processes that must not outlast the program unless it is
/// finished. It is noted where a signal handler can read it. A file or folder is removed when the
/// object goes; processes are forgotten then. No function allocates memory. Name a file or folder
/// before it is made, so that there is no moment at which it would be left behind.
class Unfinished {
public:
    static constexpr std::size_t most = 64; ///< at the same time, in the whole program

    /// Takes one of the places, if one is left.
    Unfinished() noexcept;
    ~Unfinished();
    Unfinished(const Unfinished&) = delete;
    Unfinished& operator=(const Unfinished&) = delete;

    bool has_place() const noexcept { return place_ < most; }

    /// Notes a path, instead of what was noted before; false, with ENAMETOOLONG in errno, if it is
    /// too long, and with EMFILE without a place. A folder goes with all that is in it, 64 folders
    /// deep.
    bool note_file(const char* path) noexcept;
    bool note_folder(const char* path) noexcept;

    /// Notes the leader of a process group, to be killed and reaped; it is the caller who reaps it
    /// unless the program ends. False, with EMFILE in errno, without a place.
    bool note_process(int leader) noexcept;

    /// The path that was noted, or an empty one; valid while the object lives.
    const char* path() const noexcept;

    /// It is whole, or gone already: forgets it, and gives the place back.
    void finish() noexcept;

    /// Removes it now, files and folders, and gives the place back.
    void remove() noexcept;

private:
    bool note(int kind, const char* path) noexcept;

    std::size_t place_;
};

/// What remove_unfinished needs of a signal handler's stack at most, in bytes.
inline constexpr std::size_t removal_stack = std::size_t{1} << 19;

/// Removes all that is unfinished; processes are killed first. Safe to call in a signal handler;
/// the program should end afterwards.
void remove_unfinished() noexcept;

} // namespace polydec
