// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "base/printable.h"
#include "io/pages/film.h"
#include "io/pages/page.h"
#include "io/source_file.h"
#include "tools/commands.h"
#include "tools/common.h"
#include "tools/outputs.h"
#include "tools/picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

namespace polydec::tools {

namespace {

struct ViewArguments {
    const CLI::App* command = nullptr;
    MeshArguments mesh;
    std::vector<std::filesystem::path> more;
    std::filesystem::path out;
};

/// What was written: so many pages, or one with so many cells and fields.
void tell_written(const ViewArguments& arguments, std::size_t pages, std::size_t cells,
                  std::size_t fields, Log& log) {
    const std::string out = arguments.out.string();
    const auto members = [&](JsonWriter& json) {
        json.member("out", out);
        json.member("bytes", std::filesystem::file_size(arguments.out));
        json.member("pages", pages);
        json.member("cells", cells);
        json.member("fields", fields);
    };
    tell({members, [&](Text& text) { text("{}\n", printable(out)); }}, log, arguments.mesh.tell);
}

/// Throws InvalidInput for an option that was given besides these, which apply to such a file.
void refuse_others(const ViewArguments& arguments, const char* kind,
                   const std::vector<std::string>& options) {
    for (const CLI::Option* option : arguments.command->get_options())
        if (option->count() > 0 &&
            std::find(options.begin(), options.end(), option->get_name()) == options.end())
            throw InvalidInput(fmt::format("{} does not apply to {}, {}: omit it",
                                           option->get_name(),
                                           printable(arguments.mesh.mesh.string()), kind),
                               {.path = arguments.mesh.mesh});
}

/// A page that can be one of several in a file.
bool is_album_page(const std::filesystem::path& file) {
    return lower_extension(file) == ".html";
}

/// What a file with results shows: the arrays that it has.
Page page_of_results(const std::filesystem::path& file) {
    Page page;
    if (lower_extension(file) == ".pvd")
        page = read_series(file);
    else
        page.grid = read_grid(file);
    for (auto* list : {&page.grid.point_data, &page.grid.cell_data})
        for (auto& array : *list)
            if (page.shown.empty())
                page.shown = array.name;
    page.text.facts = {fmt::format("{} cells and {} points, as in the file.",
                                   page.grid.types.size(), page.grid.points.rows())};
    return page;
}

/// One page of all that are named.
void bind_pages(const ViewArguments& arguments) {
    Log log;
    Paths pages{arguments.mesh.mesh};
    pages.insert(pages.end(), arguments.more.begin(), arguments.more.end());
    for (const auto& page : pages)
        if (!is_album_page(page))
            throw InvalidInput(fmt::format("cannot combine {} with other files: only .html pages "
                                           "can be combined; convert it with `polydec view`",
                                           printable(page.string())));
    refuse_others(arguments, "a page that is combined as it is",
                  {"MESH", "PAGES", "--out", "--json", "--max-memory", "--timing"});
    if (arguments.out.empty())
        throw InvalidInput("combined pages need an output file: add -o NAME.html");
    check_output_file(arguments.out, {".html"});
    log.timing.begin("write");
    write_album(arguments.out, arguments.out.stem().string(), pages);
    tell_written(arguments, pages.size(), 0, 0, log);
}

void run_view(ViewArguments arguments) {
    if (is_album_page(arguments.mesh.mesh) || !arguments.more.empty())
        return bind_pages(arguments);
    Log log;
    const auto& file = arguments.mesh.mesh;
    if (arguments.out.empty())
        arguments.out = file.stem().string() + ".html";
    check_output_file(arguments.out, and_pages({".mp4"}));
    if (lower_extension(arguments.out) == ".mp4")
        check_film(arguments.out);
    const std::string extension = lower_extension(file);
    Page page;
    if (extension == ".vtu" || extension == ".pvtu" || extension == ".pvd") {
        refuse_others(
            arguments, "results that are shown as they are",
            {"MESH", "--out", "--up", "--length-unit", "--json", "--max-memory", "--timing"});
        log.timing.begin("read");
        page = page_of_results(file);
    } else {
        const Discretization mesh = load(arguments.mesh, log);
        check_drawable(mesh);
        page = draw_page(mesh, file.filename().string());
    }
    page.text.title = file.filename().string();
    log.timing.begin("write");
    const std::size_t cells = page.grid.types.size(),
                      fields = page.grid.point_data.size() + page.grid.cell_data.size();
    write_page(arguments.out, std::move(page), log);
    tell_written(arguments, 1, cells, fields, log);
}

} // namespace

void add_view(CLI::App& app) {
    const auto [command, arguments] = add_command<ViewArguments>(
        app, "view", "writes a page that shows a mesh or results", run_view);
    arguments->command = command;
    add_mesh_arguments(*command, arguments->mesh);
    command
        ->add_option("PAGES", arguments->more,
                     "if MESH is an .html page: further pages to combine with it")
        ->each(note_input);
    command->add_option(
        "-o,--out", arguments->out,
        "FILE\tthe page, .html, or its picture, .png or .svg, or the film of a series, .mp4 "
        "(default: the mesh's name with .html, in the current folder)");
    add_page_options(*command);
    command->footer(
        "The page is one file that every browser opens, without a network. A picture shows the "
        "page as it opens, and needs no browser; a film needs the program ffmpeg. MESH may also "
        "be a .vtu or .pvtu file, or a .pvd file that lists such files with times: the page shows "
        "all their fields. Every command that writes -o NAME.vtu also writes such a page or "
        "picture as -o NAME.html, .png or .svg.\n\nExamples:\n"
        "  polydec view fandisk.off\n"
        "  polydec view cubes.nsc -o cubes-page.html\n"
        "  polydec view modes.vtu\n"
        "  polydec view modes.vtu -o modes.png\n"
        "  polydec view heat.pvd -o heat.html\n"
        "  polydec view heat.pvd -o heat.mp4\n"
        "  polydec view sphere.html torus.html -o both.html");
}

} // namespace polydec::tools
