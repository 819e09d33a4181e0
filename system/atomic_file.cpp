// SPDX-License-Identifier: MIT
#include "system/atomic_file.h"

#include "base/errors.h"
#include "base/printable.h"
#include "system/descriptor.h"
#include "system/regular_file.h"
#include "system/temporary_name.h"

#include <fmt/format.h>

#include <cassert>
#include <cerrno>
#include <cstdio>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace polydec {

namespace {

constexpr std::size_t buffer_bytes = std::size_t{1} << 20;

/// Opens a file that was not there; it is noted before it can exist. -1 on failure.
int create(Unfinished& temporary, const std::filesystem::path& folder) {
    int file = -1;
    make_under_new_name(folder, ".part", [&](const char* path) {
        file = temporary.note_file(path)
                   ? ::open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666)
                   : -1;
        return file >= 0;
    });
    return file;
}

/// Where the system refuses, the usual permissions of a new file have to do.
void keep_permissions(int file, mode_t mode) {
    if (::fchmod(file, mode & 0777U) != 0)
        errno = 0;
}

std::string advice(const std::filesystem::path& folder) {
    std::error_code ignored;
    if (std::filesystem::is_directory(folder, ignored))
        return "";
    return fmt::format("; create the folder {} first", folder.string());
}

} // namespace

void refuse_to_write(const std::filesystem::path& target, const std::string& reason) {
    throw IoError(fmt::format("cannot write {}: {}", printable(target.string()), reason),
                  {.path = target});
}

std::filesystem::path followed(const std::filesystem::path& target) {
    std::error_code error, missing;
    auto result =
        std::filesystem::weakly_canonical(std::filesystem::absolute(target, error), error);
    while (!error && std::filesystem::is_symlink(result, missing)) // to what is not there
        result = std::filesystem::weakly_canonical(
            result.parent_path() / std::filesystem::read_symlink(result, missing), error);
    if (error)
        refuse_to_write(target, error.message());
    return result;
}

bool is_writable(const std::filesystem::path& path) {
    constexpr mode_t anybody = S_IWUSR | S_IWGRP | S_IWOTH;
    struct stat status {};
    return ::stat(path.c_str(), &status) == 0 && (status.st_mode & anybody) != 0 &&
           ::access(path.c_str(), W_OK) == 0;
}

void check_replaceable(const std::filesystem::path& target) {
    const auto final_target = followed(target);
    struct stat status {};
    if (::stat(final_target.c_str(), &status) != 0)
        return;
    if (!S_ISREG(status.st_mode))
        refuse_to_write(target, "it is a folder, pipe or device; name a regular file");
    if (!is_writable(final_target))
        refuse_to_write(target, "it is read-only; name another file, or make it writable");
}

void write_part(const std::filesystem::path& file, std::int64_t place, std::string_view bytes,
                const std::filesystem::path& target) {
    const Descriptor opened(::open(file.c_str(), O_WRONLY | O_CLOEXEC));
    if (opened.number() < 0)
        refuse_to_write(target, system_reason());
    for (std::size_t done = 0; done < bytes.size();) {
        const auto count = ::pwrite(opened.number(), bytes.data() + done, bytes.size() - done,
                                    static_cast<off_t>(place + static_cast<std::int64_t>(done)));
        if (count < 0 && errno != EINTR)
            refuse_to_write(target, system_reason());
        done += count > 0 ? static_cast<std::size_t>(count) : 0;
    }
    if (::fsync(opened.number()) != 0 && errno != EINVAL)
        refuse_to_write(target, system_reason());
}

AtomicFile::AtomicFile(const std::filesystem::path& target)
    : target_(target), final_(followed(target)) {
    check_replaceable(target);
    struct stat status {};
    const bool exists = ::stat(final_.c_str(), &status) == 0;
    if (!temporary_.has_place())
        refuse_to_write(target,
                        fmt::format("{} files are already open for writing; write fewer at a time",
                                    Unfinished::most));
    file_ = create(temporary_, final_.parent_path());
    if (file_ < 0) {
        const auto reason = system_reason();
        temporary_.finish();
        refuse_to_write(target, reason + advice(final_.parent_path()));
    }
    if (exists)
        keep_permissions(file_, status.st_mode);
}

AtomicFile::~AtomicFile() {
    if (file_ >= 0)
        ::close(file_);
}

void AtomicFile::write(std::string_view text) {
    assert(file_ >= 0 && "no writing after commit");
    if (buffer_.size() + text.size() > buffer_bytes)
        flush();
    buffer_.append(text);
}

void AtomicFile::commit() {
    assert(file_ >= 0 && "commit only once");
    flush();

    // Some file systems cannot sync; they say EINVAL, and the close has to do.
    if (::fsync(file_) != 0 && errno != EINVAL)
        fail();
    const int file = file_;
    file_ = -1;
    if (::close(file) != 0)
        fail();
    if (std::rename(temporary_.path(), final_.c_str()) != 0)
        fail();
    temporary_.finish();
}

void AtomicFile::flush() {
    std::size_t done = 0;
    while (done < buffer_.size()) {
        const auto count = ::write(file_, buffer_.data() + done, buffer_.size() - done);
        if (count < 0 && errno != EINTR)
            fail();
        done += count > 0 ? static_cast<std::size_t>(count) : 0;
    }
    buffer_.clear();
}

void AtomicFile::fail() const {
    refuse_to_write(target_, system_reason());
}

} // namespace polydec
