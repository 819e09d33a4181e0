// SPDX-License-Identifier: MIT
#include "io/source_file.h"

#include "base/printable.h"
#include "system/memory.h"
#include "system/regular_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <new>
#include <utility>

namespace polydec {

SourceFile read_source_file(const std::filesystem::path& path) {
    const auto name = path.string();
    const auto named = [&](auto work) {
        try {
            return work();
        } catch (const IoError& error) {
            refuse_reading(name, error.what());
        }
    };
    const RegularFile file = named([&] { return RegularFile(path); });
    if (!file.is_regular())
        refuse_reading(name, "it is a folder, pipe or device; name a regular file");
    constexpr double with_mesh = 2; // what is read of it takes about as much as the text
    check_memory(with_mesh * static_cast<double>(file.size()), fmt::format("reading {}", name));
    try {
        return {name, named([&] { return file.read(); })};
    } catch (const std::bad_alloc&) {
        refuse_reading(name, fmt::format("not enough memory for its {} bytes", file.size()));
    }
}

void refuse_reading(const std::string& name, const std::string& reason) {
    throw IoError(fmt::format("cannot read {}: {}", name, reason), {.path = name});
}

void refuse_contents(const std::string& name, const std::string& text, Error::Place place) {
    place.path = name;
    throw InvalidInput(fmt::format("{}: {}", name, text), std::move(place));
}

void refuse_writing(const std::filesystem::path& path, const std::string& text,
                    Error::Place place) {
    place.path = path;
    throw InvalidInput(fmt::format("cannot write {}: {}", printable(path.string()), text),
                       std::move(place));
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
