// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace polydec {

/// Names of all entries of a folder, sorted. Throws std::bad_alloc if memory runs out;
/// std::filesystem::directory_iterator would end the program.
std::vector<std::string> folder_names(const std::filesystem::path& folder, std::error_code& error);

} // namespace polydec
