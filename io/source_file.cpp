// SPDX-License-Identifier: MIT
#include "io/source_file.h"

#include "base/errors.h"
#include "system/memory.h"
#include "system/regular_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <new>
#include <system_error>

namespace polydec {

namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& reason) {
    throw IoError(fmt::format("cannot read {}: {}", name, reason), {.path = name});
}

} // namespace

SourceFile read_source_file(const std::filesystem::path& path) {
    const auto name = path.string();
    const auto named = [&](auto work) {
        try {
            return work();
        } catch (const IoError& error) {
            refuse(name, error.what());
        }
    };
    const RegularFile file = named([&] { return RegularFile(path); });
    if (!file.is_regular())
        refuse(name, "it is a folder, pipe or device; name a regular file");
    constexpr double with_mesh = 2; // what is read of it takes about as much as the text
    check_memory(with_mesh * static_cast<double>(file.size()), fmt::format("reading {}", name));
    try {
        return {name, named([&] { return file.read(); })};
    } catch (const std::bad_alloc&) {
        refuse(name, fmt::format("not enough memory for its {} bytes", file.size()));
    }
}

std::string lower_case(std::string_view word) {
    std::string result(word);
    std::transform(result.begin(), result.end(), result.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return result;
}

std::string lower_extension(const std::filesystem::path& path) {
    return lower_case(path.extension().string());
}

} // namespace polydec
