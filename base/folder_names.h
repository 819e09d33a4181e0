// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace polydec {

/// The names of all that a folder holds, sorted. Unlike std::filesystem::directory_iterator, which
/// ends the program where memory is short, this throws std::bad_alloc.
std::vector<std::string> folder_names(const std::filesystem::path& folder, std::error_code& error);

} // namespace polydec
