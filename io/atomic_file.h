// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace polydec {

/// A file that appears whole or not at all: written under a temporary name beside its target and
/// renamed by `commit`. Without commit, as when an error is thrown, nothing is left.
/// All functions throw IoError, naming the target and the system's reason.
class AtomicFile {
public:
    /// Creates the temporary file. A target that is there must be a regular file.
    explicit AtomicFile(const std::filesystem::path& target);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(std::string_view text);

    /// Flushes, checks, closes and renames. Nothing may be written afterwards.
    void commit();

private:
    void flush();
    void close_and_remove() noexcept;
    [[noreturn]] void fail() const;

    std::filesystem::path target_; ///< as given, for messages
    std::filesystem::path final_;  ///< with symbolic links followed
    std::size_t slot_;
    int file_ = -1;
    std::string buffer_;
};

/// Removes the temporary files of all AtomicFiles that are not committed. Safe to call in a signal
/// handler; the program should end afterwards.
void remove_unfinished_files() noexcept;

} // namespace polydec
