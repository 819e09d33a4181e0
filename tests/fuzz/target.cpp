// SPDX-License-Identifier: MIT
#include "tests/fuzz/target.h"

#include "base/printable.h"

#include <algorithm>

namespace polydec::fuzz {

void require_message(std::string_view text) {
    constexpr std::size_t longest = 1000;
    constexpr auto most_lines = 3;
    require(!text.empty() && text.size() < longest, "messages have from 1 to 1000 bytes");
    require(printable_message(text, longest) == text, "messages are printable");
    require(std::count(text.begin(), text.end(), '\n') < most_lines, "messages have 1 to 3 lines");
}

} // namespace polydec::fuzz
