// SPDX-License-Identifier: MIT
#include "examples/paper/console.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstddef>
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

namespace polydec::console {

namespace {

std::array<char, std::size_t{1} << 16> gathered;
std::size_t gathered_size = 0;
int first_error = 0;
bool is_silent = false;

/// Returns 0 or the system's error number. Waits for a non-blocking stream.
int write_all(int file, std::string_view text) noexcept {
    while (!text.empty()) {
        const auto count = ::write(file, text.data(), text.size());
        if (count > 0) {
            text.remove_prefix(static_cast<std::size_t>(count));
        } else if (count < 0 && (errno == EAGAIN || errno == EWOULDBLOCK)) {
            pollfd ready{file, POLLOUT, 0};
            ::poll(&ready, 1, -1);
        } else if (count == 0) {
            return EIO; // a device that accepts nothing and gives no reason
        } else if (errno != EINTR) {
            return errno;
        }
    }
    return 0;
}

void write_gathered() noexcept {
    if (first_error == 0)
        first_error = write_all(STDOUT_FILENO, {gathered.data(), gathered_size});
    gathered_size = 0;
}

} // namespace

void be_silent(bool silent) noexcept {
    is_silent = silent;
}

void write(std::string_view text) noexcept {
    if (is_silent)
        return;
    while (!text.empty()) {
        const auto piece = text.substr(0, gathered.size() - gathered_size);
        std::copy(piece.begin(), piece.end(), gathered.data() + gathered_size);
        gathered_size += piece.size();
        text.remove_prefix(piece.size());
        if (gathered_size == gathered.size())
            write_gathered();
    }
    if (::isatty(STDOUT_FILENO) != 0)
        write_gathered();
}

int flush() noexcept {
    write_gathered();
    return first_error;
}

void forget() noexcept {
    gathered_size = 0;
}

void tell(std::string_view text) noexcept {
    if (is_silent)
        return;
    const int before = errno;
    static_cast<void>(write_all(STDERR_FILENO, text));
    errno = before;
}

void open_standard_streams() noexcept {
    // opened in the wrong mode, so using them is an error, as without them
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (::fcntl(stream, F_GETFD) < 0 && errno == EBADF)
            static_cast<void>(::open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY));
}

} // namespace polydec::console
