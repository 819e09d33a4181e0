// SPDX-License-Identifier: MIT
#include "io/pictures/draw_levels.h"

#include "base/errors.h"
#include "io/pictures/draw_cells.h"

#include <fmt/format.h>

#include <array>
#include <span>
#include <utility>
#include <vector>

namespace polydec {

LevelSets level_sets(const Discretization& mesh, const Cochain& form, const Vector& levels) {
    if (form.side != Side::primal || form.degree != 0)
        throw InvalidInput(
            fmt::format("level sets of a {} {}-form: expected a primal 0-form, which "
                        "has its values at vertices",
                        name(form.side), form.degree));
    require_points(mesh.input(), mesh.input_points(), "level sets");
    check(mesh.complex(), form);
    const Mesh cells{
        mesh.unit() * mesh.input_points(), mesh.input().simplices(mesh.dimension()), {}};
    return level_sets(cells, form.values, levels);
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
        add_cell(grid, types[static_cast<std::size_t>(n)],
                 std::span(corners, static_cast<std::size_t>(n) + 1));
        values.push_back(levels[sets.levels[static_cast<std::size_t>(i)]]);
    }
    grid.cell_data.push_back({std::move(name), std::move(values)});
    grid.cell_data.push_back({"simplex", sets.owners});
    return grid;
}

} // namespace polydec
