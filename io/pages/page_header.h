// SPDX-License-Identifier: MIT
#pragma once

#include "io/pages/page.h"
#include "io/pages/still.h"

#include <string>
#include <vector>

namespace polydec {

/// The input of a page's script: a header in JSON, and the data that it describes.
struct PageHeader {
    std::string json;
    std::string data;
    StillView still;                     ///< empty texts for points alone
    std::vector<std::string> notes = {}; ///< omissions and rounding
};

/// Throws like to_html.
PageHeader page_header(const Page& page);

} // namespace polydec
