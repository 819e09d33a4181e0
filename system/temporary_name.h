// SPDX-License-Identifier: MIT
#pragma once

#include <cerrno>
#include <filesystem>
#include <string>
#include <string_view>

namespace polydec {

/// A name that this program has not used yet, for an unfinished item. Short, so that it fits in
/// every folder in which the target fits.
std::string temporary_name(std::string_view extension);

/// Calls make(path) with temporary names in a folder while the name is taken: make then returns
/// false with errno EEXIST. Returns whether something was created; if not, errno has the reason.
template <class Make>
bool make_under_new_name(const std::filesystem::path& folder, std::string_view extension,
                         Make make) {
    constexpr int most_stale_names = 1000;
    for (int attempt = 0; attempt < most_stale_names; ++attempt) {
        if (make((folder / temporary_name(extension)).c_str()))
            return true;
        if (errno != EEXIST)
            return false;
    }
    return false;
}

} // namespace polydec
