// SPDX-License-Identifier: MIT
#include "io/pictures/draw_overlay.h"

#include "dec/surfaces/overlay.h"
#include "io/pictures/draw_cells.h"

#include <utility>

namespace polydec {

VtuGrid draw_overlay(const Discretization& discretization) {
    check_drawable(2, static_cast<int>(discretization.points.cols()));
    Overlay pieces = overlay(discretization.passage, discretization.points);
    const auto& cells = discretization.merging.carriers(2);
    VtuGrid grid;
    grid.points = discretization.unit * pieces.points;
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

PolygonMesh polygon_mesh(const Discretization& discretization) {
    if (discretization.passage.is_identity())
        return polygon_mesh(discretization.merging, discretization.unit * discretization.points);
    Overlay pieces = overlay(discretization.passage, discretization.points);
    PolygonMesh mesh;
    mesh.points = discretization.unit * pieces.points;
    mesh.corners = std::move(pieces.corners);
    mesh.offsets = std::move(pieces.offsets);
    return mesh;
}

} // namespace polydec
