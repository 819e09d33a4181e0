// SPDX-License-Identifier: MIT
#include "dec/discretization/glued_box.h"
#include "dec/surfaces/passage.h"
#include "io/pictures/draw_cells.h"

#include <utility>
#include <variant>
#include <vector>

namespace polydec {

VtuGrid draw_overlay(const Discretization& discretization) {
    check_drawable(2, static_cast<int>(discretization.points().cols()));
    Overlay pieces = overlay(discretization.passage(), discretization.measured_points());
    const auto& cells = discretization.merging().carriers(2);
    VtuGrid grid;
    grid.points = discretization.unit() * pieces.points;
    std::vector<Index> cell;
    for (Index p = 0; p < pieces.size(); ++p) {
        add_polygon(grid, {pieces.corners.data() + pieces.offsets[p],
                           pieces.corners.data() + pieces.offsets[p + 1]});
        cell.push_back(cells[pieces.triangle[p]].cell);
    }
    grid.cell_data.push_back({"cell", std::move(cell)});
    grid.cell_data.push_back({"triangle", std::move(pieces.input)});
    return grid;
}

VtuGrid draw_mesh(const Discretization& discretization) {
    const bool is_input = discretization.passage().is_identity();
    VtuGrid grid = is_input ? draw_cells(discretization, discretization.dimension())
                            : draw_overlay(discretization);
    std::vector<Index> tags = placed(discretization).tags();
    if (!tags.empty() && !is_input) {
        const auto& cells = std::get<std::vector<Index>>(grid.cell_data.front().values);
        std::vector<Index> of_pieces;
        for (const Index cell : cells)
            of_pieces.push_back(tags[cell]);
        tags = std::move(of_pieces);
    }
    if (!tags.empty())
        grid.cell_data.push_back({"tag", std::move(tags), 1, "physical group of each cell"});
    return grid;
}

} // namespace polydec
