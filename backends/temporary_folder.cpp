// SPDX-License-Identifier: MIT
#include "backends/temporary_folder.h"

#include "base/errors.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

namespace polydec {

namespace {

[[noreturn]] void refuse(const std::string& reason) {
    throw IoError(fmt::format("cannot make a temporary folder: {}\n"
                              "Let TMPDIR name a folder that can be written.",
                              reason));
}

} // namespace

TemporaryFolder::TemporaryFolder() {
    std::error_code error;
    const auto parent = std::filesystem::temp_directory_path(error);
    if (error) {
        refuse(error.message());
    }
    std::string name = (parent / "polydec-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
        refuse(fmt::format("{}: {}", parent.string(), std::generic_category().message(errno)));
    }
    path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
}

} // namespace polydec
