// SPDX-License-Identifier: MIT
#include "system/regular_file.h"

#include "base/errors.h"

#include <cerrno>
#include <fcntl.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace polydec {

std::string system_reason() {
    return std::generic_category().message(errno);
}

namespace {

[[noreturn]] void fail() {
    throw IoError(system_reason());
}

} // namespace

RegularFile::RegularFile(const std::filesystem::path& path, Links links)
    : file_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK |
                                     (links == Links::refused ? O_NOFOLLOW : 0))) {
    struct stat status {};
    if (file_.number() < 0 || ::fstat(file_.number(), &status) != 0)
        fail();
    is_regular_ = S_ISREG(status.st_mode);
    size_ = static_cast<std::size_t>(status.st_size);
}

std::string RegularFile::read(std::size_t begin, std::size_t end) const {
    std::string text(end - begin, '\0');
    std::size_t done = 0;
    while (done < text.size()) {
        const auto count = ::pread(file_.number(), text.data() + done, text.size() - done,
                                   static_cast<off_t>(begin + done));
        if (count < 0 && errno != EINTR)
            fail();
        if (count == 0)
            break;
        done += count > 0 ? static_cast<std::size_t>(count) : 0;
    }
    text.resize(done);
    return text;
}

} // namespace polydec
