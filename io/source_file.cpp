// SPDX-License-Identifier: MIT
#include "io/source_file.h"

#include "base/errors.h"
#include "base/memory.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fcntl.h>
#include <new>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace polydec {

namespace {

struct Descriptor {
    int number;
    ~Descriptor() { ::close(number); }
};

[[noreturn]] void refuse(const std::string& name, const std::string& reason) {
    throw IoError(fmt::format("cannot read {}: {}", name, reason));
}

/// Its size, after making sure that it has one: a pipe or a device may never end.
std::size_t regular_size(int file, const std::string& name) {
    struct stat status {};
    if (::fstat(file, &status) != 0) {
        refuse(name, system_reason());
    }
    if (!S_ISREG(status.st_mode)) {
        refuse(name, "it is a folder, pipe or device; name a regular file");
    }
    return static_cast<std::size_t>(status.st_size);
}

std::string read_all(int file, std::size_t size, const std::string& name) {
    std::string text(size, '\0');
    std::size_t done = 0;
    while (done < size) {
        const auto count = ::read(file, text.data() + done, size - done);
        if (count < 0 && errno == EINTR) {
            continue;
        }
        if (count < 0) {
            refuse(name, system_reason());
        }
        if (count == 0) {
            break;
        }
        done += static_cast<std::size_t>(count);
    }
    text.resize(done);
    return text;
}

} // namespace

SourceFile read_source_file(const std::filesystem::path& path) {
    const auto name = path.string();

    // Opening a pipe without a writer would wait for ever.
    const Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)};
    if (file.number < 0) {
        refuse(name, system_reason());
    }
    const auto size = regular_size(file.number, name);
    constexpr double with_mesh = 2; // what is read of it takes about as much as the text
    check_memory(with_mesh * static_cast<double>(size), fmt::format("reading {}", name));
    try {
        return {name, read_all(file.number, size, name)};
    } catch (const std::bad_alloc&) {
        refuse(name, fmt::format("memory does not suffice for its {} bytes", size));
    }
}

std::string lower_extension(const std::filesystem::path& path) {
    auto extension = path.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return extension;
}

std::string system_reason() {
    return std::generic_category().message(errno);
}

} // namespace polydec
