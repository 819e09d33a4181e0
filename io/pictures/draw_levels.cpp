// SPDX-License-Identifier: MIT
#include "base/errors.h"
#include "dec/discretization/glued_box.h"
#include "dec/fields/transfer.h"
#include "io/pictures/draw_cells.h"

#include <fmt/format.h>

#include <array>
#include <span>
#include <utility>
#include <vector>

namespace polydec {

LevelSets level_sets(const Discretization& given, const Cochain& form, const Vector& levels) {
    if (form.side != Side::primal || form.degree != 0)
        throw InvalidInput(fmt::format("level sets of a {} {}-form are not defined: expected a "
                                       "primal 0-form, with values at vertices",
                                       name(form.side), form.degree));
    const Discretization& mesh = placed(given);
    require_points(mesh.input(), mesh.input_points(), "a level set");
    check(given.complex(), form);
    const int n = mesh.dimension();
    Mesh cells{mesh.input_points(), mesh.input().simplices(n), {}};
    for (Index t = 0; t < cells.simplices.rows() && n > 0; ++t)
        if (mesh.input().orientation(t) < 0)
            std::swap(cells.simplices(t, n - 1), cells.simplices(t, n));
    LevelSets sets = level_sets(cells, form_at_places(given, form).values, levels);
    if (given.box())
        for (Index& owner : sets.owners)
            owner = given.box()->map(given.dimension()).onto[owner];
    return sets;
}

VtuGrid draw_levels(const LevelSets& sets, const Vector& levels, std::string name) {
    const int n = sets.mesh.dimension();
    check_drawable(n, sets.mesh.ambient_dimension());
    constexpr std::array types{VtuCell::vertex, VtuCell::line, VtuCell::triangle, VtuCell::tetra};
    VtuGrid grid;
    grid.points = sets.mesh.points;
    std::vector<double> values;
    for (Index i = 0; i < sets.mesh.simplices.rows(); ++i) {
        const Index* corners = sets.mesh.simplices.row(i).data();
        add_cell(grid, types[n], std::span(corners, static_cast<std::size_t>(n) + 1));
        values.push_back(levels[sets.levels[i]]);
    }
    grid.cell_data.push_back({std::move(name), std::move(values)});
    grid.cell_data.push_back({"simplex", sets.owners});
    return grid;
}

} // namespace polydec
