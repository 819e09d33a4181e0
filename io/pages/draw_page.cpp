// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "dec/discretization/glued_box.h"
#include "dec/fields/flat_and_sharp.h"
#include "io/pages/page.h"
#include "io/pictures/draw_cells.h"
#include "io/pictures/draw_fields.h"
#include "meshes/unit_of_length.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <utility>
#include <variant>

namespace polydec {

namespace {

/// How many vertices each n-cell that is drawn has.
std::vector<Index> corner_counts(const Discretization& given) {
    const Discretization& mesh = placed(given);
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
    const Vector volumes =
        in_input_units(mesh.volumes().primal(n), mesh.unit(), n, "volumes of cells");
    add_field(grid, mesh, n,
              {names[n - 1],
               {Side::primal, n, volumes},
               fmt::format("of each cell, in units of length^{}", n)});
}

std::vector<std::string> facts_of(const Discretization& mesh) {
    const int n = mesh.dimension();
    std::vector<Index> input, merged;
    for (int k = 0; k <= n; ++k) {
        input.push_back(mesh.input().size(k));
        merged.push_back(mesh.complex().size(k));
    }
    return {fmt::format("Dimension {} in {} coordinates.", n, mesh.ambient_dimension()),
            fmt::format("Cells of degree 0 .. {}: {} in the input, {} after merging.", n,
                        fmt::join(input, ", "), fmt::join(merged, ", "))};
}

/// Modes of one eigenvalue are rotated at will: tells of those that their radii do not separate.
std::string in_words_multiple(const Spectrum& spectrum) {
    std::string text;
    const auto& values = spectrum.eigenvalues;
    for (Index first = 0, last = 0; first < values.size(); first = last) {
        for (last = first + 1; last < values.size(); ++last)
            if (values[last] - values[last - 1] > spectrum.radii[last] + spectrum.radii[last - 1])
                break;
        if (last - first > 1)
            text += fmt::format("; modes {} to {} are one basis of a {}-fold eigenvalue", first,
                                last - 1, last - first);
    }
    return text;
}

PageTable table_of(const Spectrum& spectrum, const std::vector<NamedForm>& modes) {
    PageTable table{.columns = {"", "eigenvalue", "radius", "residual"},
                    .below = in_words(spectrum.certificate) + in_words_multiple(spectrum)};
    for (Index i = 0; i < spectrum.eigenvalues.size(); ++i) {
        table.rows.push_back({std::to_string(i), fmt::format("{:.12g}", spectrum.eigenvalues[i]),
                              fmt::format("{:.2e}", spectrum.radii[i]),
                              fmt::format("{:.2e}", spectrum.residuals[i])});
        if (i < std::ssize(modes))
            table.fields.push_back(modes[i].name);
    }
    return table;
}

} // namespace

Page draw_page(const Discretization& mesh, std::string title) {
    Page page;
    page.text.title = std::move(title);
    page.text.facts = facts_of(mesh);
    page.grid = draw_mesh(mesh);
    if (mesh.passage().is_identity()) {
        page.mesh = mesh;
        add_measures(page.grid, mesh);
    } else {
        page.groups = std::get<std::vector<Index>>(page.grid.cell_data.front().values);
        page.text.facts.emplace_back(
            "Edges were flipped: the page draws cells over the triangles of the input and shows "
            "the other edges of these triangles as merged away.");
    }
    return page;
}

Page draw_page(const Discretization& mesh, const std::vector<NamedForm>& fields,
               std::string title) {
    if (fields.empty())
        throw InvalidInput("a page needs fields: name one, or draw only the cells");
    const int k = drawn_degree(mesh, fields);
    Page page;
    page.text.title = std::move(title);
    page.text.facts = facts_of(mesh);
    page.grid = draw_cells(mesh, k);
    for (const NamedForm& field : fields) {
        add_field(page.grid, mesh, k, field);
        if (field.vectors.size() == 0)
            add_arrows(page, field.name, mesh, field.form);
    }
    page.shown = fields.front().name;
    page.mesh = mesh;
    return page;
}

PageStep draw_step(const Page& page, std::string time, const std::vector<NamedForm>& fields) {
    const Discretization& mesh = page.mesh.value();
    const int k = drawn_degree(mesh, fields);
    PageStep step{{}, std::move(time)};
    for (const NamedForm& field : fields)
        add_field(step, mesh, k, field);
    for (const PageArrows& arrows : page.arrows) {
        step.vectors.push_back(arrows.vectors);
        for (const NamedForm& field : fields)
            if (field.name == arrows.field && has_proxy(mesh, field.form))
                step.vectors.back() = vectors_at_cells(mesh, field.form);
    }
    return step;
}

Page draw_page(const Discretization& mesh, const Spectrum& spectrum, std::string title) {
    const std::vector<NamedForm> modes = shown_modes(spectrum);
    Page page = draw_page(mesh, modes, std::move(title));
    page.text.facts.insert(page.text.facts.begin(),
                           fmt::format("The smallest eigenvalues, in length^-2, of the Laplace-de "
                                       "Rham operator on {} {}-forms, and their modes, of norm 1.",
                                       name(spectrum.side), spectrum.degree));
    page.text.table = table_of(spectrum, modes);
    return page;
}

std::string in_words(const Certificate& certificate) {
    if (!certificate.complete)
        return "not certified: copies of multiple eigenvalues may be missing";
    return fmt::format(
        "certified: {} eigenvalues of this mesh lie below {:.8g} by inertia, {} were computed, "
        "each within its radius of the value",
        certificate.below_shift, certificate.shift, certificate.returned_below_shift);
}

} // namespace polydec
