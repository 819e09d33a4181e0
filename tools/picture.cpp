// SPDX-License-Identifier: MIT
#include "tools/picture.h"

#include "io/pictures/draw_cells.h"
#include "io/pictures/draw_overlay.h"
#include "io/source_file.h"
#include "meshes/unit_of_length.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <string_view>
#include <vector>

namespace polydec::tools {

namespace {

std::string& kept_command() {
    static std::string text;
    return text;
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

/// How many vertices each merged n-cell has.
std::vector<Index> corner_counts(const Discretization& mesh) {
    const int n = mesh.dimension();
    std::vector<Index> counts;
    for (Index cell = 0; cell < mesh.complex().size(n); ++cell)
        counts.push_back(static_cast<Index>(mesh.merging().vertices(n, cell).size()));
    return counts;
}

/// Of the cells of the file, in its units.
void add_measures(VtuGrid& grid, const Discretization& mesh) {
    const int n = mesh.dimension();
    constexpr std::array names{"length", "area", "volume"};
    grid.cell_data.push_back(
        {"corners", corner_counts(mesh), 1, "number of vertices of each cell"});
    add_form(grid, mesh, names[static_cast<std::size_t>(n - 1)],
             {Side::primal, n,
              in_input_units(mesh.volumes().primal(n), mesh.unit(), n, "volumes of cells")},
             fmt::format("of each cell, in units of length^{}", n));
}

std::vector<std::string> facts_of(const Discretization& mesh) {
    const int n = mesh.dimension();
    std::vector<Index> input, merged;
    for (int k = 0; k <= n; ++k) {
        input.push_back(mesh.input().size(k));
        merged.push_back(mesh.complex().size(k));
    }
    return {fmt::format("Dimension {} in {} coordinates.", n, mesh.points().cols()),
            fmt::format("Cells of degree 0 .. {}: {} in the input, {} after merging.", n,
                        fmt::join(input, ", "), fmt::join(merged, ", "))};
}

void append(std::vector<std::string>& list, const std::vector<std::string>& more) {
    list.insert(list.end(), more.begin(), more.end());
}

} // namespace

void set_command_text(int argc, const char* const* argv) {
    auto& text = kept_command();
    text = "polydec";
    for (int i = 1; i < argc; ++i)
        text += " " + quoted(argv[i]);
}

const std::string& command_text() {
    return kept_command();
}

bool is_page(const std::filesystem::path& out) {
    return lower_extension(out) == ".html";
}

void write_picture(const std::filesystem::path& out, Page page, const Log& log) {
    if (!is_page(out))
        return write_vtu(out, page.grid);
    page.text.command = command_text();
    append(page.text.warnings, log.warnings);
    write_page(out, page);
}

void write_picture(const std::filesystem::path& out, const Discretization& mesh,
                   std::span<const NamedForm> forms, PageText text, const Log& log) {
    const auto& first = forms.front().form;
    Page page;
    page.grid = draw_cells(mesh, cell_degree(mesh.complex(), first.side, first.degree));
    page.text = std::move(text);
    for (const auto& [name, form, about] : forms) {
        add_form(page.grid, mesh, name, form, about);
        if (is_page(out))
            add_arrows(page, name, mesh, form);
    }
    page.shown = forms.front().name;
    append(page.text.facts, facts_of(mesh));
    page.mesh = mesh;
    write_picture(out, std::move(page), log);
}

Page page_of_cells(const std::filesystem::path& out, const Discretization& mesh,
                   const std::filesystem::path& file) {
    Page page;
    page.text.title = file.filename().string();
    page.text.facts = facts_of(mesh);
    if (mesh.passage().is_identity()) {
        page.grid = draw_cells(mesh, mesh.dimension());
        page.mesh = mesh;
        if (is_page(out))
            add_measures(page.grid, mesh);
    } else {
        page.grid = draw_overlay(mesh);
        page.groups = std::get<std::vector<Index>>(page.grid.cell_data.front().values);
        page.text.facts.emplace_back("Edges were flipped: cells are shown as they lie over the "
                                     "input's triangles, whose other edges count as merged away.");
    }
    if (!mesh.tags().empty())
        page.grid.cell_data.push_back({"tag", mesh.tags(), 1, "physical group of each cell"});
    return page;
}

} // namespace polydec::tools
