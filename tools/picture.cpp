// SPDX-License-Identifier: MIT
#include "tools/picture.h"

#include "base/errors.h"
#include "base/printable.h"
#include "io/meshes/mesh_files.h"
#include "io/pictures/draw_cells.h"
#include "io/pictures/draw_fields.h"
#include "io/source_file.h"
#include "tools/options.h"
#include "tools/outputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>
#include <vector>

namespace polydec::tools {

namespace {

std::string& kept_command() {
    static std::string text;
    return text;
}

/// The options of add_page_options.
PageText& kept_options() {
    static PageText options;
    return options;
}

/// As a shell would take it for one word.
std::string quoted(std::string_view word) {
    constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456"
                                       "789_-+=./:,@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string_view::npos)
        return std::string(word);
    std::string result = "'";
    for (const char c : word)
        result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

void append(std::vector<std::string>& list, const std::vector<std::string>& more) {
    list.insert(list.end(), more.begin(), more.end());
}

void write_levels(const PictureArguments& to, const Discretization& mesh, const NamedForm& function,
                  std::vector<VtuArray> numbers) {
    const Vector levels = equal_levels(function.form.values, to.isolines);
    const LevelSets sets = level_sets(mesh, function.form, levels);
    if (lower_extension(to.out) == ".obj" && mesh.dimension() > 1)
        return write_mesh(to.out, sets.mesh);
    if (lower_extension(to.out) == ".obj")
        throw InvalidInput(fmt::format("cannot write {}: level sets on a curve are points, which "
                                       "need a .vtu file",
                                       printable(to.out.string())),
                           {.path = to.out});
    VtuGrid grid = draw_levels(sets, levels, function.name);
    grid.field_data = std::move(numbers);
    grid.field_data.push_back(vtu_array("levels", levels));
    write_vtu(to.out, grid, to.vtu);
}

} // namespace

void set_command_text(int argc, const char* const* argv) {
    auto& text = kept_command();
    text = "polydec";
    for (int i = 1; i < argc; ++i)
        text += " " + quoted(argv[i]);
}

void add_page_options(CLI::App& command) {
    command
        .add_option_function<std::string>(
            "--up",
            [](const std::string& axis) {
                kept_options().up = static_cast<int>(axis.front() - 'x');
            },
            "AXIS\tthe axis that points up in a page (default: y for .obj .ply .off, else z)")
        ->check(one_of({"x", "y", "z"}));
    command.add_option("--length-unit", kept_options().length_unit,
                       "NAME\tunit of length for the scale bar of a page, such as mm");
}

void check_page_options(const std::filesystem::path& out) {
    const PageText& options = kept_options();
    if ((options.up || !options.length_unit.empty()) && !is_page(out))
        throw InvalidInput(fmt::format("{} needs a page or its picture: add -o NAME.html, .png or "
                                       ".svg, or omit it",
                                       options.up ? "--up" : "--length-unit"));
}

std::vector<const char*> and_pages(std::vector<const char*> extensions) {
    extensions.insert(extensions.end(), {".html", ".png", ".svg"});
    return extensions;
}

bool is_page(const std::filesystem::path& out) {
    const auto pages = and_pages({});
    return std::find(pages.begin(), pages.end(), lower_extension(out)) != pages.end();
}

void add_picture(CLI::App& command, PictureArguments& picture, const std::string& what) {
    command.add_option(
        "-o,--out", picture.out,
        fmt::format("FILE\twrite {} to this .vtu file, .html page, or .png or .svg picture", what));
    add_float32(command, picture);
    add_page_options(command);
}

void add_float32(CLI::App& command, PictureArguments& picture) {
    command
        .add_flag_callback(
            "--float32", [&picture] { picture.vtu.numbers = VtuNumbers::float32; },
            "write 7 digits of coordinates and values to a .vtu file, not 16")
        ->needs("--out");
}

void add_isolines(CLI::App& command, PictureArguments& picture) {
    command
        .add_option("--isolines", picture.isolines,
                    "N\twrite N equidistant level sets instead, to a .vtu or .obj file")
        ->check(CLI::Range(1, 1'000'000))
        ->needs("--out");
}

void check_float32(const PictureArguments& picture) {
    if (picture.vtu.numbers == VtuNumbers::float32 && lower_extension(picture.out) != ".vtu")
        throw InvalidInput(fmt::format("cannot write {}: --float32 needs a .vtu file",
                                       printable(picture.out.string())),
                           {.path = picture.out});
}

void check_picture(const PictureArguments& picture) {
    check_page_options(picture.out);
    if (picture.out.empty())
        return;
    check_output_file(picture.out,
                      picture.isolines > 0 ? std::vector{".vtu", ".obj"} : and_pages({".vtu"}));
    check_float32(picture);
}

PageText page_of(const Log& log, const std::string& what, std::vector<std::string> facts) {
    PageText text;
    text.title = fmt::format("{}: {}", log.mesh.filename().string(), what);
    text.facts = std::move(facts);
    return text;
}

PageText in_page(PageText text, const Log& log) {
    text.command = kept_command();
    text.file = log.mesh;
    text.up = kept_options().up;
    text.length_unit = kept_options().length_unit;
    append(text.warnings, log.warnings);
    return text;
}

void write_page(const std::filesystem::path& out, Page page, const Log& log) {
    page.text = in_page(std::move(page.text), log);
    polydec::write_page(out, page);
}

void write_picture(const PictureArguments& to, const Discretization& mesh,
                   const std::vector<NamedForm>& forms, PageText text,
                   std::vector<VtuArray> numbers, const Log& log, const Mesh& lines) {
    if (to.isolines > 0)
        return write_levels(to, mesh, forms.front(), std::move(numbers));
    if (is_page(to.out)) {
        Page page = draw_page(mesh, forms);
        std::swap(page.text, text);
        append(page.text.facts, text.facts);
        const Points none(0, lines.points.cols());
        if (lines.simplices.rows() > 0)
            page.arrows.push_back({forms.front().name, none, none, lines});
        return write_page(to.out, std::move(page), log);
    }
    VtuGrid grid = draw_fields(mesh, forms);
    std::move(numbers.begin(), numbers.end(), std::back_inserter(grid.field_data));
    write_vtu(to.out, grid, to.vtu);
}

} // namespace polydec::tools
