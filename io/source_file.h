// SPDX-License-Identifier: MIT
#pragma once

#include "base/errors.h"

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

/// Throw IoError "cannot read name: reason", InvalidInput "name: text", and InvalidInput "cannot
/// write path: text". The place names the file, and what it is given.
[[noreturn]] void refuse_reading(const std::string& name, const std::string& reason);
[[noreturn]] void refuse_contents(const std::string& name, const std::string& text,
                                  Error::Place place = {});
[[noreturn]] void refuse_writing(const std::filesystem::path& path, const std::string& text,
                                 Error::Place place = {});

/// A word in lower case; letters beyond ASCII stay.
std::string lower_case(std::string_view word);

/// The extension with its dot, in lower case.
std::string lower_extension(const std::filesystem::path& path);

} // namespace polydec
