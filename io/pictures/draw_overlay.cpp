// SPDX-License-Identifier: MIT
#include "io/pictures/draw_overlay.h"

#include "dec/overlay.h"
#include "io/pictures/draw_cells.h"

#include <utility>

namespace polydec {

namespace {

/// The polygon that each flipped triangle belongs to.
std::vector<Index> cells_of_triangles(const MergedSurface& merging) {
    const IncidenceMatrix& pieces = merging.diamonds[2];
    std::vector<Index> cells(static_cast<std::size_t>(pieces.cols()));
    for (Index cell = 0; cell < pieces.rows(); ++cell)
        for (IncidenceMatrix::InnerIterator piece(pieces, cell); piece; ++piece)
            cells[piece.col()] = cell;
    return cells;
}

} // namespace

VtuGrid draw_overlay(const Discretization& discretization) {
    check_drawable(2, static_cast<int>(discretization.points.cols()));
    Overlay pieces = overlay(discretization);
    const auto cells = cells_of_triangles(discretization.intrinsic->merging);
    VtuGrid grid;
    grid.points = discretization.unit * pieces.points;
    std::vector<Index> cell;
    for (Index p = 0; p < pieces.size(); ++p) {
        add_cell(grid, VtuCell::polygon,
                 {pieces.corners.data() + pieces.offsets[p],
                  pieces.corners.data() + pieces.offsets[p + 1]});
        cell.push_back(cells[pieces.triangle[p]]);
    }
    grid.cell_data.push_back({"cell", std::move(cell)});
    grid.cell_data.push_back({"triangle", std::move(pieces.input)});
    return grid;
}

PolygonMesh polygon_mesh(const Discretization& discretization) {
    if (!discretization.intrinsic)
        return polygon_mesh(discretization.merging, discretization.unit * discretization.points);
    Overlay pieces = overlay(discretization);
    PolygonMesh mesh;
    mesh.points = discretization.unit * pieces.points;
    mesh.corners = std::move(pieces.corners);
    mesh.offsets = std::move(pieces.offsets);
    return mesh;
}

} // namespace polydec
