// SPDX-License-Identifier: MIT
#include "system/folder_names.h"

#include <algorithm>
#include <cerrno>
#include <dirent.h>
#include <memory>
#include <utility>

namespace polydec {

std::vector<std::string> folder_names(const std::filesystem::path& folder, std::error_code& error) {
    struct Close {
        void operator()(DIR* list) const { ::closedir(list); }
    };
    std::vector<std::string> names;
    const std::unique_ptr<DIR, Close> list(::opendir(folder.string().c_str()));
    errno = list ? 0 : errno;
    while (const dirent* const entry = list ? ::readdir(list.get()) : nullptr) {
        std::string name = entry->d_name;
        if (name != "." && name != "..")
            names.push_back(std::move(name));
        errno = 0;
    }
    error = std::error_code(errno, std::generic_category());
    std::sort(names.begin(), names.end());
    return names;
}

} // namespace polydec
