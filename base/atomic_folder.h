// SPDX-License-Identifier: MIT
#pragma once

#include "base/unfinished.h"

#include <filesystem>
#include <functional>
#include <string_view>

namespace polydec {

/// A folder that appears whole or not at all: filled under a temporary name beside its target, and
/// renamed by `commit`. A folder that is there already is replaced in one step if it is a result of
/// the same kind, and stays as it is until then. Without commit nothing is left, nor is it after a
/// signal whose handler calls remove_unfinished.
class AtomicFolder {
public:
    /// Says of a file of the target by its name whether it belongs to an earlier result.
    using IsOurs = std::function<bool(std::string_view name)>;

    /// Makes the temporary folder. Throws InvalidInput, naming a file, if the target holds one that
    /// is not ours, or is the folder that the program runs in; IoError, with the system's reason.
    AtomicFolder(const std::filesystem::path& target, const IsOurs& is_ours);
    ~AtomicFolder();
    AtomicFolder(const AtomicFolder&) = delete;
    AtomicFolder& operator=(const AtomicFolder&) = delete;

    /// Where files are written until commit.
    std::filesystem::path path() const { return temporary_.path(); }

    /// Renames it, and removes what was there. Throws IoError, and InvalidInput as above.
    void commit();

private:
    void make_parents();
    void replace();
    [[noreturn]] void fail() const;

    std::filesystem::path target_; ///< as given, for messages
    std::filesystem::path final_;  ///< with symbolic links followed
    IsOurs is_ours_;
    Unfinished temporary_, displaced_;
    std::filesystem::path made_; ///< the first folder on the way to the target that was not there
};

/// Throws InvalidInput as AtomicFolder does. A target that is not there is fine.
void check_replaceable(const std::filesystem::path& target, const AtomicFolder::IsOurs& is_ours);

} // namespace polydec
