// SPDX-License-Identifier: MIT
#pragma once

#include "io/pages/page.h"

#include <string>
#include <vector>

namespace polydec {

/// The input of a page's script: a header in JSON, and the data that it describes.
struct PageHeader {
    std::string json;
    std::string data;
    std::string still;                   ///< an SVG picture
    std::string caption = {};            ///< meaning of its colors; may be empty
    std::vector<std::string> notes = {}; ///< omissions and rounding
};

/// Throws like to_html.
PageHeader page_header(const Page& page);

} // namespace polydec
