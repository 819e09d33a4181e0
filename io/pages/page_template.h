// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace polydec {

/// The fixed parts of every page: page.html, album.html, page.css, and page.js, the scripts of this
/// folder one after the other. CMake generates them from these files.
std::string_view page_template(std::string_view name);

} // namespace polydec
