// SPDX-License-Identifier: MIT
#include "io/pictures/draw_fields.h"

#include "base/checks.h"
#include "io/pictures/draw_cells.h"

#include <fmt/format.h>

#include <set>

namespace polydec {

namespace {

int degree_of_cells(const Discretization& mesh, const NamedForm& field) {
    return cell_degree(mesh.complex(), field.form.side, field.form.degree);
}

} // namespace

int drawn_degree(const Discretization& mesh, const std::vector<NamedForm>& fields) {
    std::set<int> degrees;
    for (const NamedForm& field : fields)
        degrees.insert(degree_of_cells(mesh, field));
    return degrees.size() == 1 ? *degrees.begin() : mesh.dimension();
}

void add_field(VtuData& picture, const Discretization& mesh, int k, const NamedForm& field) {
    const auto& [name, form, about, vectors] = field;
    const int own = degree_of_cells(mesh, field);
    if (vectors.size() > 0)
        check_as_many(fmt::format("rows of `{}`", name), vectors.rows(), mesh.complex().size(own));
    VtuArray array = vtu_array(name, vectors.size() > 0
                                         ? drawn_values(mesh, form.side, 0, vectors)
                                         : drawn_values(mesh, form.side, form.degree, form.values));
    array.about = !about.empty() ? about
                  : vectors.size() > 0
                      ? "vectors"
                      : fmt::format("a {} {}-form", polydec::name(form.side), form.degree);
    if (own > 0 && own != k)
        array.degree = own;
    auto& list = own == 0 ? picture.point_data : own == k ? picture.cell_data : picture.field_data;
    list.push_back(std::move(array));
}

void add_fields(VtuData& picture, const Discretization& mesh,
                const std::vector<NamedForm>& fields) {
    const int k = drawn_degree(mesh, fields);
    for (const NamedForm& field : fields) {
        add_field(picture, mesh, k, field);
        if (field.vectors.size() == 0)
            add_vectors(picture, mesh, field.name, field.form);
    }
}

VtuGrid draw_fields(const Discretization& mesh, const std::vector<NamedForm>& fields) {
    VtuGrid grid = draw_cells(mesh, drawn_degree(mesh, fields));
    add_fields(grid, mesh, fields);
    return grid;
}

} // namespace polydec
