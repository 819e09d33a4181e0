// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace polydec {

/// Combines several pages into one HTML file that shows one page at a time; hidden pages are not
/// drawn. The album itself needs no script. `pages` are results of to_html, in order, and keep
/// their titles. Throws InvalidInput for no pages; with its number, for a text that is not a page;
/// and above 64 MB.
std::string album_html(const std::string& title, const std::vector<std::string>& pages);

/// The album of these files; it appears whole or not at all. Throws like album_html, naming the
/// file; IoError if a page cannot be read or the album cannot be written.
void write_album(const std::filesystem::path& path, const std::string& title,
                 const std::vector<std::filesystem::path>& pages);

} // namespace polydec
