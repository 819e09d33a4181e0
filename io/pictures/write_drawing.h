// SPDX-License-Identifier: MIT
#pragma once

#include "io/pictures/svg_drawing.h"

#include <filesystem>
#include <string_view>

namespace polydec {

/// Writes the text of an SVG file as .svg, or as .png or .pdf by the program rsvg-convert or
/// cairosvg, the first on PATH; a PNG has two pixels for each of the drawing. The file appears
/// whole or not at all. Throws InvalidInput for another extension; BackendUnavailable if neither
/// program is there; SolverFailure, with its last words, if it fails; and like AtomicFile.
void write_drawing(const std::filesystem::path& path, std::string_view svg);
void write_drawing(const std::filesystem::path& path, const SvgDrawing& drawing);

/// Throws like write_drawing for the extension and the programs, before any work is done.
void check_drawing_file(const std::filesystem::path& path);

} // namespace polydec
