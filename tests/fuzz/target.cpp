// SPDX-License-Identifier: MIT
#include "tests/fuzz/target.h"

#include <algorithm>

namespace polydec::fuzz {

void require_message(std::string_view text) {
    constexpr std::size_t longest = 1000;
    constexpr auto most_lines = 3;
    const auto is_shown = [](char c) { return c == '\n' || (c >= ' ' && c <= '~'); };
    require(!text.empty() && text.size() < longest, "messages have from 1 to 1000 bytes");
    require(std::all_of(text.begin(), text.end(), is_shown), "messages are printable");
    require(std::count(text.begin(), text.end(), '\n') < most_lines, "messages have 1 to 3 lines");
}

} // namespace polydec::fuzz
