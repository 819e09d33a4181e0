// SPDX-License-Identifier: MIT
#pragma once

#include <fmt/format.h>

#include <string_view>
#include <utility>

/// The one way of the programs to their standard streams. A stream that is closed, full or a broken
/// pipe ends nothing: what could not be printed is noted, and told at the end.
namespace polydec::console {

/// To standard output, which is written when enough has gathered, and by flush.
void write(std::string_view text) noexcept;

template <typename... Values>
void print(fmt::format_string<Values...> format, Values&&... values) {
    write(fmt::format(format, std::forward<Values>(values)...));
}

/// Writes what has gathered. 0, or the system's number of what went wrong first since the program
/// began.
int flush() noexcept;

/// Drops what has gathered since it was last written.
void forget() noexcept;

/// To standard error at once, if that can be written; needs no memory, and is safe in a signal
/// handler.
void tell(std::string_view text) noexcept;

/// Whether nothing is written from now on, to either stream: of processes that work on one thing
/// together one speaks.
void be_silent(bool silent) noexcept;

/// The numbers 0 to 2 belong to the standard streams, also where the program was started without
/// them: else the next file that is opened would become standard output. To be called first.
void open_standard_streams() noexcept;

} // namespace polydec::console
