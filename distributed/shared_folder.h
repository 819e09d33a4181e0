// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/ranks.h"
#include "system/atomic_folder.h"

#include <memory>
#include <string>

namespace polydec {

/// Collective: sends a text of rank 0 to all ranks.
inline std::string told_by_first(const Ranks& ranks, const std::string& text) {
    const auto own =
        ranks.rank() == 0 ? std::vector<char>(text.begin(), text.end()) : std::vector<char>();
    const auto told = ranks.of_all(own);
    return {told.begin(), told.end()};
}

/// AtomicFolder of rank 0, filled by all ranks. Every function is collective, and throws likewise.
class SharedFolder {
public:
    SharedFolder(const Ranks& ranks, const std::filesystem::path& target,
                 const AtomicFolder::IsOurs& is_ours)
        : ranks_(ranks) {
        ranks.together("output", [&] {
            if (ranks.rank() == 0)
                folder_ = std::make_unique<AtomicFolder>(target, is_ours);
        });
        path_ = told_by_first(ranks, folder_ ? folder_->path().string() : "");
    }

    const std::filesystem::path& path() const { return path_; }

    void commit() {
        ranks_.together("output", [&] {
            if (folder_)
                folder_->commit();
        });
    }

private:
    Ranks ranks_;
    std::unique_ptr<AtomicFolder> folder_;
    std::filesystem::path path_;
};

} // namespace polydec
