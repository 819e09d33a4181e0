// SPDX-License-Identifier: MIT
#pragma once

#include "complex/merging.h"
#include "io/pictures/vtu.h"

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace polydec {

/// The visible geometry of cells: triangles, or the lines of curves. Corners are rows of points.
struct PageFaces {
    /// The side from corner i of a triangle to the next takes two bits, from 2 i on.
    enum Line : std::uint8_t {
        hidden = 0,  ///< between triangles of one cell; not an edge of any mesh
        edge = 1,    ///< an edge of cells
        removed = 2, ///< an edge removed by merging
    };

    int dimension = 0;                        ///< of the cells
    std::vector<Index> corners;               ///< three to a triangle
    std::vector<std::array<Index, 2>> owners; ///< the cells of each triangle; -1: none
    std::vector<Index> sides;                 ///< for each triangle, three times two bits
    std::vector<Index> edges;                 ///< for each side, the 1-cell around it, -1: none
    std::vector<Index> faces;                 ///< for each triangle, the 2-cell around it
    std::vector<Index> lines;                 ///< two corners to a cell, if dimension is 1

    Index size() const { return static_cast<Index>(owners.size()); }
    Index count_cells() const; ///< one more than the largest owner

    /// What is seen if only some cells are kept: the triangles, or lines, with one of these as the
    /// first owner and none on the other side.
    PageFaces visible(const std::vector<bool>& kept) const;

    /// The entry of a field at this place (see PageField) that a corner, or end of a line, shows;
    /// -1: none.
    Index entry(std::string_view place, Index corner) const;
};

/// The cells of largest dimension, by their numbers in the grid; polygons are split into triangles.
/// If groups are given, polygons of one group are parts of one cell: edges between them count as
/// removed. Edges and faces have no numbers. Throws InvalidInput like split_polygons.
PageFaces page_faces(const VtuGrid& grid, const std::vector<Index>& groups = {});

/// The merged cells drawn by their simplices, so that bent cells are shown correctly. Dimensions 1
/// to 3.
PageFaces page_faces(const Merging& merging);

/// The largest dimension of the cells in a grid.
int grid_dimension(const VtuGrid& grid);

} // namespace polydec
