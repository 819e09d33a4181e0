// SPDX-License-Identifier: MIT
#include "io/meshes/vtk_grid.h"

#include "system/memory.h"

#include <fmt/format.h>

#include <limits>

namespace polydec {

void check_grid(const VtkGrid& grid, const Scanner& place) {
    double points = 1;
    for (const std::size_t along : grid.points)
        points *= static_cast<double>(along);
    if (points > std::numeric_limits<Index>::max())
        place.fail(fmt::format("a grid of {} x {} x {} points; expected fewer than 2^31; divide it",
                               grid.points[0], grid.points[1], grid.points[2]));
    constexpr double bytes_of_point = 24, bytes_of_cell = 120;
    check_memory(points * (bytes_of_point + bytes_of_cell),
                 fmt::format("a grid of {} points", points));
}

std::vector<double> grid_points(const VtkGrid& grid, const Scanner& place) {
    check_grid(grid, place);
    std::vector<double> points;
    points.reserve(3 * grid.points[0] * grid.points[1] * grid.points[2]);
    for (std::size_t k = 0; k < grid.points[2]; ++k)
        for (std::size_t j = 0; j < grid.points[1]; ++j)
            for (std::size_t i = 0; i < grid.points[0]; ++i)
                points.insert(points.end(),
                              {grid.places[0][i], grid.places[1][j], grid.places[2][k]});
    return points;
}

void add_grid_cells(const VtkGrid& grid, const Scanner& place, VtkArrays& arrays) {
    check_grid(grid, place);
    std::vector<std::size_t> cells, strides, corners{0}; // of the axes that there are
    std::size_t stride = 1;
    for (const std::size_t points : grid.points) {
        if (points > 1) {
            cells.push_back(points - 1);
            strides.push_back(stride);
            const std::size_t before = corners.size();
            for (std::size_t c = 0; c < before; ++c)
                corners.push_back(corners[c] + stride);
        }
        stride *= points;
    }
    if (cells.empty())
        place.fail("a grid of one point; expected more along an axis; export it again");
    constexpr std::array types{3.0, 8.0, 11.0};
    cells.resize(3, 1);
    strides.resize(3, 0);
    for (std::size_t k = 0; k < cells[2]; ++k)
        for (std::size_t j = 0; j < cells[1]; ++j)
            for (std::size_t i = 0; i < cells[0]; ++i) {
                const std::size_t origin = i * strides[0] + j * strides[1] + k * strides[2];
                for (const std::size_t corner : corners)
                    arrays.corners.push_back(static_cast<double>(origin + corner));
                arrays.ends.push_back(static_cast<double>(arrays.corners.size()));
                arrays.types.push_back(types[corners.size() == 2 ? 0 : corners.size() / 4]);
            }
}

} // namespace polydec
