// SPDX-License-Identifier: MIT
#pragma once

#include "system/unfinished.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace polydec {

/// Throws IoError, naming the target and the reason.
[[noreturn]] void refuse_to_write(const std::filesystem::path& target, const std::string& reason);

/// The absolute path of a target, with symbolic links followed, also those to what is not there
/// yet. Throws IoError if there is none, such as for links in a circle.
std::filesystem::path followed(const std::filesystem::path& target);

/// A file that appears whole or not at all: written under a temporary name beside its target, and
/// renamed by `commit`. Without commit, e.g. after an exception, nothing is left; nor after a
/// signal whose handler calls remove_unfinished. All functions throw IoError, naming the target and
/// the system's reason.
class AtomicFile {
public:
    /// Creates the temporary file. Throws like check_replaceable.
    explicit AtomicFile(const std::filesystem::path& target);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    void write(std::string_view text);

    /// Path until commit: other processes may write parts of the file there (write_part).
    std::filesystem::path unfinished() const { return temporary_.path(); }

    /// Flushes, checks, closes and renames. No writes are allowed afterwards.
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

/// Writes bytes at a position of an existing file, and flushes them to storage. Throws IoError,
/// naming the final target.
void write_part(const std::filesystem::path& file, std::int64_t place, std::string_view bytes,
                const std::filesystem::path& target);

/// Throws IoError if the target exists and is not a regular file, or is read-only.
void check_replaceable(const std::filesystem::path& target);

/// Whether this process may write to an existing file or folder; read-only files are not writable
/// for a superuser either.
bool is_writable(const std::filesystem::path& path);

} // namespace polydec
