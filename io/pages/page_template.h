// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace polydec {

/// The parts of a page that are the same for all: page.html, album.html, page.css, and page.js,
/// which are the scripts of this folder one after the other. CMake makes them from these files.
std::string_view page_template(std::string_view name);

} // namespace polydec
