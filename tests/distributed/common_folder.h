// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/ranks.h"
#include "tests/support/test.h"

namespace polydec::test {

/// A folder that all ranks share; rank 0 makes and removes it.
class CommonFolder {
public:
    explicit CommonFolder(const Ranks& ranks) : ranks_(ranks) {
        std::vector<char> name;
        if (ranks.rank() == 0) {
            std::string path = std::filesystem::temp_directory_path() / "polydec-XXXXXX";
            path = ::mkdtemp(path.data());
            name.assign(path.begin(), path.end());
        }
        name = ranks.of_all(name);
        folder_ = std::string(name.begin(), name.end());
    }
    ~CommonFolder() {
        ranks_.any(false); // all are done
        if (ranks_.rank() == 0)
            std::filesystem::remove_all(folder_);
    }
    CommonFolder(const CommonFolder&) = delete;
    CommonFolder& operator=(const CommonFolder&) = delete;

    std::filesystem::path operator/(const char* name) const { return folder_ / name; }

private:
    Ranks ranks_;
    std::filesystem::path folder_;
};

/// Work of rank 0 before the others go on.
template <class Work>
void on_rank_0(const Ranks& ranks, Work work) {
    ranks.together("a file", [&] {
        if (ranks.rank() == 0)
            work();
    });
}

} // namespace polydec::test
