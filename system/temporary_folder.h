// SPDX-License-Identifier: MIT
#pragma once

#include "system/unfinished.h"

#include <filesystem>

namespace polydec {

/// A new folder that only its owner can read, in the system's folder for temporary files (TMPDIR).
/// The destructor removes it with all its contents, without allocating memory; so does
/// remove_unfinished, called before the program ends.
class TemporaryFolder {
public:
    /// Throws IoError, naming the folder and the system's reason, if it cannot be created.
    TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

private:
    Unfinished noted_;
    std::filesystem::path path_;
};

} // namespace polydec
