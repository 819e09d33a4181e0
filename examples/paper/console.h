// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <string_view>
#include <utility>

/// Access of the programs to standard streams. A stream that is closed, full or a broken pipe does
/// not end the program. Failed output is recorded, and reported at the end.
namespace polydec::console {

/// Buffered output to standard output, written when the buffer is full, and by flush.
void write(std::string_view text) noexcept;

template <typename... Values>
void print(fmt::format_string<Values...> format, Values&&... values) {
    write(fmt::format(format, std::forward<Values>(values)...));
}

/// Writes the buffer. Returns 0, or the system's error number of the first failure since the
/// program began.
int flush() noexcept;

/// Discards the buffer.
void forget() noexcept;

/// Writes to standard error at once if possible. Allocates no memory, and is safe in a signal
/// handler.
void tell(std::string_view text) noexcept;

/// Whether to write nothing from now on, to either stream. Of several cooperating processes, only
/// one prints.
void be_silent(bool silent) noexcept;

/// Reserves the descriptors 0 to 2 for the standard streams if the program was started without
/// them. Otherwise the next opened file would become standard output. Call it first.
void open_standard_streams() noexcept;

} // namespace polydec::console
