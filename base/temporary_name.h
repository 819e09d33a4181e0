// SPDX-License-Identifier: MIT
#pragma once

#include <cerrno>
#include <filesystem>
#include <string>
#include <string_view>

namespace polydec {

/// A name that this program has not used yet, for what is not whole. Short, so that every folder in
/// which the target fits has room for it.
std::string temporary_name(std::string_view extension);

/// Calls make(path) with temporary names in a folder, as long as there is something of that name:
/// it returns false then, with EEXIST in errno. Returns whether something was made; else errno
/// tells why not.
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
