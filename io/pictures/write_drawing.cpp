// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "io/pictures/svg_drawing.h"
#include "io/source_file.h"
#include "system/atomic_file.h"
#include "system/child_process.h"
#include "system/held_signals.h"
#include "system/temporary_folder.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace polydec {

namespace {

namespace fs = std::filesystem;

/// A program that turns SVG into other formats, with its option for twice as many pixels.
struct SvgConverter {
    fs::path program;
    const char* twice;
};

std::string drawing_format(const fs::path& path) {
    const std::string extension = lower_extension(path);
    if (extension != ".svg" && extension != ".png" && extension != ".pdf")
        refuse_contents(path.string(), "a drawing is written as .svg, .png or .pdf");
    return extension.substr(1);
}

SvgConverter require_converter(const std::string& format) {
    for (const auto& [name, twice] : {std::pair("rsvg-convert", "-z2"), {"cairosvg", "-s2"}})
        if (const auto program = find_program(name))
            return {*program, twice};
    throw BackendUnavailable(fmt::format(
        ".{} files need the program rsvg-convert or cairosvg, and neither is on PATH\nTo get one: "
        "apt-get install librsvg2-bin, brew install librsvg, or pip install cairosvg; or write "
        ".svg",
        format));
}

std::string converted_svg(std::string_view svg, const std::string& format) {
    const SvgConverter converter = require_converter(format);
    const HeldSignals held; // outlives the folder: a signal is delivered when that is gone
    const TemporaryFolder folder;
    std::ofstream(folder.path() / "drawing.svg", std::ios::binary) << svg;
    const std::vector<std::string> arguments =
        format == "png"
            ? std::vector<std::string>{"-fpng", converter.twice, "-odrawing.png", "drawing.svg"}
            : std::vector<std::string>{"-fpdf", "-odrawing.pdf", "drawing.svg"};
    const ChildOutcome outcome = run_child(converter.program, arguments, folder.path());
    std::ifstream file(folder.path() / ("drawing." + format), std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(file), {}};
    if (outcome.end != ChildEnd::exited || outcome.code != 0 || bytes.empty())
        throw SolverFailure(fmt::format("{} made no .{} of the drawing; write .svg instead\n{}",
                                        converter.program.string(), format,
                                        outcome.output.substr(0, 300)));
    return bytes;
}

} // namespace

void check_drawing_file(const fs::path& path) {
    const std::string format = drawing_format(path);
    if (format != "svg")
        require_converter(format);
}

void write_drawing(const fs::path& path, std::string_view svg) {
    const std::string format = drawing_format(path);
    AtomicFile file(path);
    file.write(format == "svg" ? std::string(svg) : converted_svg(svg, format));
    file.commit();
}

void write_drawing(const fs::path& path, const SvgDrawing& drawing) {
    write_drawing(path, to_svg(drawing));
}

} // namespace polydec
