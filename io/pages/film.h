// SPDX-License-Identifier: MIT
#pragma once

#include "io/pages/page.h"

#include <filesystem>

namespace polydec {

/// Throws IoError, with the remedy, if the program ffmpeg, which makes films, is missing.
void check_film(const std::filesystem::path& path);

/// A film of all steps as .mp4, H.264 in 1280 x 800 pixels, from the pictures of draw_steps. The
/// file appears whole or not at all. Throws like check_film and to_png; InvalidInput for a page
/// without steps; IoError if ffmpeg or writing fails.
void write_film(const std::filesystem::path& path, const Page& page);

} // namespace polydec
