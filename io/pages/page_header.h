// SPDX-License-Identifier: MIT
#pragma once

#include "io/pages/page.h"

#include <string>
#include <vector>

namespace polydec {

/// What the script of a page reads: a header in JSON, and the data that it speaks of.
struct PageHeader {
    std::string json;
    std::string data;
    std::string still;                   ///< an SVG picture
    std::string caption = {};            ///< what its colors are; may be empty
    std::vector<std::string> notes = {}; ///< what was left out or rounded
};

/// Throws like to_html.
PageHeader page_header(const Page& page);

} // namespace polydec
