// SPDX-License-Identifier: MIT
#pragma once

#include "system/unfinished.h"

#include <filesystem>
#include <functional>
#include <string_view>

namespace polydec {

/// A folder that appears whole or not at all: filled under a temporary name beside its target, and
/// renamed by `commit`. An existing folder stays unchanged until then; it is replaced in one step
/// if it is a result of the same kind. Without commit nothing is left, nor after a signal whose
/// handler calls remove_unfinished.
class AtomicFolder {
public:
    /// Whether a file of the target, given by name, belongs to an earlier result.
    using IsOurs = std::function<bool(std::string_view name)>;

    /// Creates the temporary folder. Throws InvalidInput, naming the file, if the target contains a
    /// file that is not ours, or is the working directory; IoError, with the system's reason.
    AtomicFolder(const std::filesystem::path& target, const IsOurs& is_ours);
    ~AtomicFolder();
    AtomicFolder(const AtomicFolder&) = delete;
    AtomicFolder& operator=(const AtomicFolder&) = delete;

    /// Folder for the files until commit.
    std::filesystem::path path() const { return temporary_.path(); }

    /// Renames the folder, and removes the previous one. Throws IoError, and InvalidInput as above.
    void commit();

private:
    void make_parents();
    void replace();
    [[noreturn]] void fail() const;

    std::filesystem::path target_; ///< as given, for messages
    std::filesystem::path final_;  ///< with symbolic links followed
    IsOurs is_ours_;
    Unfinished temporary_, displaced_;
    std::filesystem::path made_; ///< first folder on the way to the target that did not exist
};

/// Throws InvalidInput like AtomicFolder. The target need not exist.
void check_replaceable(const std::filesystem::path& target, const AtomicFolder::IsOurs& is_ours);

} // namespace polydec
