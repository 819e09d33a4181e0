// SPDX-License-Identifier: MIT
#pragma once

#include <csignal>
#include <cstddef>

namespace polydec {

/// Signals that request a program's end, and end it by default.
inline constexpr int ending_signals[] = {SIGINT, SIGTERM,
#ifdef SIGHUP // Windows has the two above alone
                                         SIGHUP, SIGQUIT, SIGXCPU,
                                         SIGXFSZ
#endif
};

/// A file, folder or process group that must not outlast the program unless it is finished. It is
/// recorded where a signal handler can read it. The destructor removes a file or folder; it only
/// forgets processes. No function allocates memory. Record a file or folder before creating it, so
/// that it can never be left behind.
class Unfinished {
public:
    static constexpr std::size_t most = 64; ///< at the same time, in the whole program

    /// Takes one of the places, if one is free.
    Unfinished() noexcept;
    ~Unfinished();
    Unfinished(const Unfinished&) = delete;
    Unfinished& operator=(const Unfinished&) = delete;

    bool has_place() const noexcept { return place_ < most; }

    /// Records a path in place of the previous record. Returns false, with errno ENAMETOOLONG if
    /// the path is too long, or EMFILE without a place. A folder is removed with all its contents,
    /// up to 64 folders deep.
    bool note_file(const char* path) noexcept;
    bool note_folder(const char* path) noexcept;

    /// Records the leader of a process group, to be killed and reaped; the caller reaps it unless
    /// the program ends. Returns false, with errno EMFILE, without a place.
    bool note_process(int leader) noexcept;

    /// The recorded path, or an empty one; valid during the object's lifetime.
    const char* path() const noexcept;

    /// The item is complete or already gone: forgets it and frees the place.
    void finish() noexcept;

    /// Removes a file or folder now, and frees the place.
    void remove() noexcept;

private:
    bool note(int kind, const char* path) noexcept;

    std::size_t place_;
};

/// Upper bound on the stack that remove_unfinished needs in a signal handler, in bytes.
inline constexpr std::size_t removal_stack = std::size_t{1} << 19;

/// Removes everything unfinished; kills processes first. Safe to call in a signal handler; the
/// program should end afterwards.
void remove_unfinished() noexcept;

} // namespace polydec
