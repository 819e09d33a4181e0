// SPDX-License-Identifier: MIT
#include "backends/mesher/temporary_folder.h"

#include "base/errors.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>
#include <unistd.h>

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
    if (!noted_.has_place()) {
        refuse(fmt::format("{} of them, or of files, are in use already", Unfinished::most));
    }
    std::string name = (parent / "polydec-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
        refuse(fmt::format("{}: {}", parent.string(), std::generic_category().message(errno)));
    }
    if (!noted_.note_folder(name.c_str())) {
        ::rmdir(name.c_str());
        refuse(fmt::format("{}: {}", parent.string(), std::generic_category().message(errno)));
    }
    path_ = name;
}

} // namespace polydec
