// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace polydec {

/// Text as it stands in HTML, between tags or in quotes: what marks do in it, and what would turn
/// the direction of writing, is shown and not done.
std::string html_text(std::string_view text);

/// Text as JSON that may stand in an element `script`: in quotes, without < > &.
std::string json_text(std::string_view text);

/// A finite number as JSON, which reads back as the same.
std::string json_number(double value);

/// A template with each mark {{name}} replaced by that part, in which no mark is looked for. Throws
/// InvalidInput if it becomes larger than 64 MB, which browsers do not open well.
std::string filled_page(std::string_view text,
                        const std::map<std::string_view, std::string>& parts);

/// A JSON array of values that are JSON.
std::string json_array(const std::vector<std::string>& values);

} // namespace polydec
