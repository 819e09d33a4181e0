// SPDX-License-Identifier: MIT
#pragma once

#include "system/descriptor.h"

#include <cstddef>
#include <filesystem>
#include <string>

namespace polydec {

/// A file opened for reading, only if it is a regular file: a pipe or a device may never end.
/// Throws IoError with only the system's reason; the caller knows the name.
class RegularFile {
public:
    enum class Links { followed, refused };

    /// Does not wait for the other end of a pipe.
    explicit RegularFile(const std::filesystem::path& path, Links links = Links::followed);

    bool is_regular() const { return is_regular_; }
    std::size_t size() const { return size_; } ///< in bytes

    /// The whole content; less than size() bytes if the file has become shorter.
    std::string read() const { return read(0, size_); }

    /// The bytes from `begin` to `end`; fewer if the file is shorter.
    std::string read(std::size_t begin, std::size_t end) const;

private:
    Descriptor file_;
    bool is_regular_ = false;
    std::size_t size_ = 0;
};

/// The system's message for the current value of errno.
std::string system_reason();

} // namespace polydec
