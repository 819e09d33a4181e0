// SPDX-License-Identifier: MIT
#include "system/temporary_folder.h"

#include "base/errors.h"
#include "system/regular_file.h"
#include "system/temporary_name.h"

#include <fmt/format.h>

#include <string>
#include <sys/stat.h>
#include <system_error>

namespace polydec {

namespace {

[[noreturn]] void refuse(const std::string& reason) {
    throw IoError(fmt::format("cannot create a temporary folder: {}\n"
                              "Set TMPDIR to a writable folder.",
                              reason));
}

} // namespace

TemporaryFolder::TemporaryFolder() {
    std::error_code error;
    const auto parent = std::filesystem::temp_directory_path(error);
    if (error)
        refuse(error.message());
    if (!noted_.has_place())
        refuse(fmt::format("{} temporary folders or unfinished files already exist",
                           Unfinished::most));
    // noted before it is there, so that no signal comes in between
    const bool made = make_under_new_name(parent, "", [&](const char* path) {
        return noted_.note_folder(path) && ::mkdir(path, 0700) == 0;
    });
    if (!made) {
        const auto reason = system_reason();
        noted_.finish(); // what bears the last name is not ours
        refuse(fmt::format("{}: {}", parent.string(), reason));
    }
    path_ = noted_.path();
}

} // namespace polydec
