// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace polydec {

/// One HTML file of several pages, of which one is seen at a time; those that are not looked at are
/// not drawn. It needs no script itself. `pages` are what to_html made, in order; their titles are
/// theirs. Throws InvalidInput, by its number, for what is no page, for none, and for what makes
/// more than 64 MB.
std::string album_html(const std::string& title, const std::vector<std::string>& pages);

/// The album of these files; it appears whole or not at all. Throws like album_html, naming the
/// file; IoError if one cannot be read, or the album not be written.
void write_album(const std::filesystem::path& path, const std::string& title,
                 const std::vector<std::filesystem::path>& pages);

} // namespace polydec
