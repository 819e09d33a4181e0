// SPDX-License-Identifier: MIT
#pragma once

#include "base/unfinished.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace polydec {

/// A file that appears whole or not at all: written under a temporary name beside its target and
/// renamed by `commit`. Without commit, as when an error is thrown, nothing is left; nor is it
/// after a signal whose handler calls remove_unfinished. All functions throw IoError, naming the
/// target and the system's reason.
class AtomicFile {
public:
    /// Creates the temporary file. Throws as check_replaceable does.
    explicit AtomicFile(const std::filesystem::path& target);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(std::string_view text);

    /// Where it is until then: other processes may write parts of it there (write_part).
    std::filesystem::path unfinished() const { return temporary_.path(); }

    /// Flushes, checks, closes and renames. Nothing may be written afterwards.
    void commit();

private:
    void flush();
    [[noreturn]] void fail() const;

    std::filesystem::path target_; ///< as given, for messages
    std::filesystem::path final_;  ///< with symbolic links followed
    Unfinished temporary_;
    int file_ = -1;
    std::string buffer_;
};

/// Writes bytes at a place of a file that is there, and has them stored. Throws IoError, naming the
/// target that they are for.
void write_part(const std::filesystem::path& file, std::int64_t place, std::string_view bytes,
                const std::filesystem::path& target);

/// Throws IoError if the target is there and is no regular file, or is read-only.
void check_replaceable(const std::filesystem::path& target);

/// Whether this process may write to a file or a folder that is there; what is marked read-only
/// stays so for a superuser as well.
bool is_writable(const std::filesystem::path& path);

} // namespace polydec
