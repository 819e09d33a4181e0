// SPDX-License-Identifier: MIT
#pragma once

#include "base/unfinished.h"

#include <filesystem>

namespace polydec {

/// A new folder that its owner alone can read, in the system's folder for temporary files (TMPDIR).
/// It goes, with all that is in it, when the object does, which needs no memory, and where the
/// program calls remove_unfinished before it ends.
class TemporaryFolder {
public:
    /// Throws IoError, naming the folder and the system's reason, if none can be made.
    TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    const std::filesystem::path& path() const { return path_; }

private:
    Unfinished noted_;
    std::filesystem::path path_;
};

} // namespace polydec
