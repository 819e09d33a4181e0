// SPDX-License-Identifier: MIT
#include "io/pages/page.h"

#include "base/errors.h"
#include "dec/fields/cell_centers.h"
#include "dec/fields/flat_and_sharp.h"
#include "dec/fields/streamlines.h"
#include "io/base64.h"
#include "io/pages/film.h"
#include "io/pages/page_header.h"
#include "io/pages/page_template.h"
#include "io/pages/page_text.h"
#include "io/pages/still.h"
#include "io/source_file.h"
#include "system/atomic_file.h"

#include <fmt/format.h>

#include <map>

namespace polydec {

namespace {

std::string table_html(const PageTable& table, const VtuGrid& grid) {
    if (table.rows.empty())
        return "";
    std::map<std::string, std::size_t> numbers;
    for (const auto* list : {&grid.point_data, &grid.cell_data})
        for (const auto& array : *list)
            numbers.emplace(array.name, numbers.size());

    std::string html = "<table id=\"table\"><thead><tr>";
    for (const auto& column : table.columns)
        html += fmt::format("<th scope=\"col\">{}</th>", html_text(column));
    html += "</tr></thead>\n<tbody>\n";
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const auto field = i < table.fields.size() ? numbers.find(table.fields[i]) : numbers.end();
        html +=
            field == numbers.end() ? "<tr>" : fmt::format("<tr data-field=\"{}\">", field->second);
        for (const auto& entry : table.rows[i])
            html += fmt::format("<td>{}</td>", html_text(entry));
        html += "</tr>\n";
    }
    html += "</tbody></table>\n";
    if (!table.below.empty())
        html += fmt::format("<p id=\"certificate\">{}</p>\n", html_text(table.below));
    return html;
}

/// Paragraphs in a section with a heading; nothing where there are none.
std::string section_html(const char* id, const char* heading,
                         const std::vector<std::string>& paragraphs) {
    if (paragraphs.empty())
        return "";
    std::string html = fmt::format("<section id=\"{}\"><h2>{}</h2>\n", id, heading);
    for (const auto& paragraph : paragraphs)
        html +=
            fmt::format("<{0}>{1}</{0}>\n", paragraph.find('\n') == std::string::npos ? "p" : "pre",
                        html_text(paragraph));
    return html + "</section>\n";
}

/// Along the arrows of a surface; in a solid they would hide each other.
void add_flow(Page& page, PageArrows& arrows, const Discretization& mesh) {
    if (mesh.dimension() != 2)
        return;
    try {
        arrows.lines = streamlines(mesh, arrows.vectors);
    } catch (const InvalidInput& error) {
        page.text.warnings.push_back(
            fmt::format("`{}` has no streamlines: {}", arrows.field, error.what()));
    }
}

/// The address of a picture that a page holds itself.
std::string address(const std::string& png) {
    return png.empty() ? "data:," : "data:image/png;base64," + base64_text(png);
}

} // namespace

void add_arrows(Page& page, const std::string& field, const Discretization& mesh,
                const Cochain& form) {
    try {
        PageArrows arrows{field, {}, vectors_at_cells(mesh, form)};
        if (arrows.vectors.rows() == 0)
            return;
        arrows.sites = cell_centroids(mesh, mesh.dimension());
        add_flow(page, arrows, mesh);
        page.arrows.push_back(std::move(arrows));
    } catch (const InvalidInput& error) {
        page.text.warnings.push_back(fmt::format("`{}` has no arrows: {}", field, error.what()));
    }
}

std::string to_html(const Page& page) {
    PageHeader header = page_header(page);
    const auto& text = page.text;
    std::string command;
    if (!text.command.empty())
        command =
            fmt::format("<p id=\"command\">Made by <code>{}</code></p>", html_text(text.command));
    return filled_page(page_template("page.html"),
                       {{"style", std::string(page_template("page.css"))},
                        {"script", std::string(page_template("page.js"))},
                        {"title", html_text(text.title)},
                        {"command", command},
                        {"still", address(header.still.png)},
                        {"thumbnail", address(header.still.thumbnail)},
                        {"description", html_text(header.still.words)},
                        {"warnings", section_html("warnings", "Warnings", text.warnings)},
                        {"notes", section_html("notes", "About this page", header.notes)},
                        {"facts", section_html("facts", "What is shown", text.facts)},
                        {"table", table_html(text.table, page.grid)},
                        {"header", std::move(header.json)},
                        {"data", std::move(header.data)}});
}

void write_page(const std::filesystem::path& path, const Page& page) {
    const std::string extension = lower_extension(path);
    if (extension == ".mp4")
        return write_film(path, page);
    const std::string text = extension == ".png"   ? to_png(page)
                             : extension == ".svg" ? to_svg(page)
                                                   : to_html(page);
    AtomicFile file(path);
    file.write(text);
    file.commit();
}

} // namespace polydec
