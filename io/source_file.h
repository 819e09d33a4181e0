// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace polydec {

/// The contents of a file; the name is for messages.
struct SourceFile {
    std::string name;
    std::string text;
};

/// Reads a whole regular file. Throws IoError, naming path and reason.
SourceFile read_source_file(const std::filesystem::path& path);

/// A word in lower case; letters beyond ASCII stay.
std::string lower_case(std::string_view word);

/// The extension with its dot, in lower case.
std::string lower_extension(const std::filesystem::path& path);

} // namespace polydec
