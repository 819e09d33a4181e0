// SPDX-License-Identifier: MIT
#include "io/pages/page.h"
#include "io/pictures/draw_cells.h"
#include "python/bindings/convert.h"

namespace polydec::python {

namespace {

/// Forms on the k-cells, drawn: their name, side, degree and values, and what they are in words.
using NamedForms = std::vector<std::tuple<std::string, std::string, int, Numbers, std::string>>;

void add_forms(VtuGrid& grid, const Discretization& mesh, const NamedForms& forms) {
    for (const auto& [name, side, degree, values, about] : forms)
        add_form(grid, mesh, name, form(side, degree, values), about);
}

/// Writes the cells that carry some forms, with these.
void write_picture(const std::string& path, const Discretization& mesh, int k,
                   const NamedForms& forms) {
    VtuGrid grid = draw_cells(mesh, k);
    add_forms(grid, mesh, forms);
    unlocked([&] { write_vtu(path, grid); });
}

PageText text_of(const std::string& title, const std::vector<std::string>& facts,
                 const py::dict& table, const Discretization& mesh) {
    PageText text{.title = title, .facts = facts, .warnings = mesh.warnings()};
    if (!table.empty()) {
        text.table = {table["columns"].cast<std::vector<std::string>>(),
                      table["rows"].cast<std::vector<std::vector<std::string>>>(),
                      table["fields"].cast<std::vector<std::string>>(),
                      table["below"].cast<std::string>()};
    }
    return text;
}

/// The page of these forms; of several times those of each, in `steps`.
std::string page(const Discretization& mesh, int k, const NamedForms& forms,
                 const std::vector<std::pair<std::string, NamedForms>>& steps,
                 const std::string& title, const std::vector<std::string>& facts,
                 const py::dict& table) {
    Page page;
    page.text = text_of(title, facts, table, mesh);
    page.grid = draw_cells(mesh, k);
    VtuGrid bare = page.grid;
    add_forms(page.grid, mesh, forms);
    for (const auto& [time, at_time] : steps) {
        bare.point_data.clear();
        bare.cell_data.clear();
        add_forms(bare, mesh, at_time);
        page.steps.push_back({time, bare.point_data, bare.cell_data});
    }
    if (steps.empty()) // arrows would stand still
        for (const auto& [name, side, degree, values, about] : forms)
            add_arrows(page, name, mesh, form(side, degree, values));
    if (!forms.empty())
        page.shown = std::get<0>(forms.front());
    page.mesh = mesh;
    return unlocked([&] { return to_html(page); });
}

} // namespace

void add_pages(py::module_& module) {
    module.def("write_vtu", &write_picture);
    module.def("page", &page);
}

} // namespace polydec::python
