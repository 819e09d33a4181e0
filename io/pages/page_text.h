// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace polydec {

/// Text escaped for HTML, between tags or in quotes: markup, and characters that change the writing
/// direction, are shown literally.
std::string html_text(std::string_view text);

/// Text as JSON for use in an element `script`: in quotes, without < > &.
std::string json_text(std::string_view text);

/// A finite number as JSON that reads back exactly.
std::string json_number(double value);

/// A template with each mark {{name}} replaced by its part; marks inside parts are not replaced.
/// Throws InvalidInput above 64 MB, which browsers do not open well.
std::string filled_page(std::string_view text,
                        const std::map<std::string_view, std::string>& parts);

/// A JSON array of values in JSON.
std::string json_array(const std::vector<std::string>& values);

} // namespace polydec
