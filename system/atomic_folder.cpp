// SPDX-License-Identifier: MIT
#include "system/atomic_folder.h"

#include "base/errors.h"
#include "base/printable.h"
#include "system/atomic_file.h"
#include "system/descriptor.h"
#include "system/folder_names.h"
#include "system/regular_file.h"
#include "system/temporary_name.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace polydec {

namespace {

using Path = std::filesystem::path;

Path resolved_folder(const Path& target) {
    const auto result = followed(target);
    return result.has_filename() ? result : result.parent_path();
}

/// The innermost folder around it that is there.
Path existing_parent(const Path& path) {
    std::error_code ignored;
    Path parent = path.parent_path();
    while (parent.has_relative_path() && !std::filesystem::exists(parent, ignored))
        parent = parent.parent_path();
    return parent;
}

/// What was written into a folder is to outlast a loss of power. Not all file systems can do so.
void sync(const Path& folder) {
    const Descriptor file(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (file.number() >= 0)
        static_cast<void>(::fsync(file.number()));
}

/// Exchanges two folders in one step, where the file system can.
bool exchange(const Path& a, const Path& b) {
#ifdef RENAME_EXCHANGE
    return ::renameat2(AT_FDCWD, a.c_str(), AT_FDCWD, b.c_str(), RENAME_EXCHANGE) == 0;
#else
    static_cast<void>(a), static_cast<void>(b);
    errno = ENOSYS;
    return false;
#endif
}

constexpr const char* extension = ".parts";

} // namespace

void check_replaceable(const Path& target, const AtomicFolder::IsOurs& is_ours) {
    std::error_code error, none;
    const auto name = printable(target.string());
    if (std::filesystem::equivalent(target, std::filesystem::current_path(none), none))
        throw InvalidInput(fmt::format("cannot write {}: it is the current folder, whose contents "
                                       "would be replaced; name another folder",
                                       name),
                           {.path = target});
    for (const auto& file : folder_names(target, error)) {
        struct stat status {};
        const bool is_file =
            ::lstat((target / file).c_str(), &status) == 0 && S_ISREG(status.st_mode);
        if (!is_file || !is_ours(file))
            throw InvalidInput(
                fmt::format("cannot write {}: it contains '{}', which is not part of an earlier "
                            "result and would be lost; name another folder, or remove this one",
                            name, printable(file)),
                {.path = target});
    }
    if (error && error != std::errc::no_such_file_or_directory &&
        error != std::errc::not_a_directory)
        refuse_to_write(target, error.message());
}

AtomicFolder::AtomicFolder(const Path& target, const IsOurs& is_ours)
    : target_(target), final_(resolved_folder(target)), is_ours_(is_ours) {
    check_replaceable(final_, is_ours_);
    if (!temporary_.has_place() || !displaced_.has_place())
        refuse_to_write(target, fmt::format("{} files are already open for writing; write fewer at "
                                            "a time",
                                            Unfinished::most));
    // what was there may be there once more, and stays where it is until the end
    const bool is_made =
        make_under_new_name(existing_parent(final_), extension, [&](const char* path) {
            return temporary_.note_folder(path) && ::mkdir(path, 0777) == 0;
        });
    if (is_made)
        return;
    // one that is there and has the name is another's
    const auto reason = system_reason();
    temporary_.finish();
    refuse_to_write(target, reason);
}

AtomicFolder::~AtomicFolder() {
    // not committed: what was made on the way goes, from the inside
    std::error_code ignored;
    if (temporary_.has_place() && !made_.empty())
        for (Path folder = final_.parent_path(); folder != made_.parent_path();
             folder = folder.parent_path())
            std::filesystem::remove(folder, ignored);
}

void AtomicFolder::make_parents() {
    std::error_code error;
    for (Path parent = final_.parent_path();
         parent.has_relative_path() && !std::filesystem::exists(parent, error);
         parent = parent.parent_path())
        made_ = parent;
    std::filesystem::create_directories(final_.parent_path(), error);
    if (error)
        refuse_to_write(target_, error.message());
}

/// Puts the folder where another one is, which gets the temporary name.
void AtomicFolder::replace() {
    struct stat before {};
    if (::stat(final_.c_str(), &before) == 0)
        static_cast<void>(::chmod(temporary_.path(), before.st_mode & 07777U));
    if (exchange(temporary_.path(), final_)) {
        temporary_.remove();
        return;
    }
    if (errno != EINVAL && errno != ENOSYS)
        fail();
    // without that, there is a moment at which the result is under neither name, but never lost
    const Path aside = final_.parent_path() / temporary_name(extension);
    if (std::rename(final_.c_str(), aside.c_str()) != 0)
        fail();
    if (std::rename(temporary_.path(), final_.c_str()) != 0) {
        const int reason = errno;
        static_cast<void>(std::rename(aside.c_str(), final_.c_str()));
        errno = reason;
        fail();
    }
    temporary_.finish();
    static_cast<void>(displaced_.note_folder(aside.c_str()));
    displaced_.remove();
}

void AtomicFolder::commit() {
    sync(temporary_.path());
    check_replaceable(final_, is_ours_);
    std::error_code ignored;
    if (std::filesystem::is_directory(final_, ignored)) {
        replace();
    } else {
        make_parents();
        if (std::rename(temporary_.path(), final_.c_str()) != 0)
            fail();
        temporary_.finish();
    }
    sync(final_.parent_path());
}

void AtomicFolder::fail() const {
    refuse_to_write(target_, system_reason());
}

} // namespace polydec
