// SPDX-License-Identifier: MIT
#include "io/pictures/draw_overlay.h"

#include "dec/surfaces/overlay.h"
#include "io/pictures/draw_cells.h"

#include <utility>

namespace polydec {

VtuGrid draw_overlay(const Discretization& discretization) {
    check_drawable(2, static_cast<int>(discretization.points().cols()));
    Overlay pieces = overlay(discretization.passage(), discretization.points());
    const auto& cells = discretization.merging().carriers(2);
    VtuGrid grid;
    grid.points = discretization.unit() * pieces.points;
    std::vector<Index> cell;
    for (Index p = 0; p < pieces.size(); ++p) {
        add_cell(grid, VtuCell::polygon,
                 {pieces.corners.data() + pieces.offsets[p],
                  pieces.corners.data() + pieces.offsets[p + 1]});
        cell.push_back(cells[pieces.triangle[p]].cell);
    }
    grid.cell_data.push_back({"cell", std::move(cell)});
    grid.cell_data.push_back({"triangle", std::move(pieces.input)});
    return grid;
}

} // namespace polydec
