// SPDX-License-Identifier: MIT
#pragma once

#include "complex/merging.h"
#include "io/pictures/vtu.h"

#include <array>
#include <cstdint>
#include <vector>

namespace polydec {

/// What one sees of cells: triangles, or the lines of curves. Corners are rows of points.
struct PageFaces {
    /// The side from corner i of a triangle to the next one takes two bits, from 2 i on.
    enum Line : std::uint8_t {
        hidden = 0,  ///< between triangles of one cell that no mesh has
        edge = 1,    ///< a true edge of cells
        removed = 2, ///< an edge that was merged away
    };

    int dimension = 0;                        ///< of the cells
    std::vector<Index> corners;               ///< three to a triangle
    std::vector<std::array<Index, 2>> owners; ///< the cells of each triangle; -1: none
    std::vector<Index> sides;                 ///< of each triangle three times two bits
    std::vector<Index> edges;                 ///< of each side the 1-cell it lies in, -1: none
    std::vector<Index> faces;                 ///< of each triangle the 2-cell it lies in
    std::vector<Index> lines;                 ///< two corners to a cell, if dimension is 1

    Index size() const { return static_cast<Index>(owners.size()); }
};

/// The cells of largest dimension, by their numbers in the grid; polygons split into triangles.
/// Polygons of one group, if groups are given, are parts of one cell: edges between them were
/// merged away. Edges and faces have no numbers there. Throws InvalidInput like split_polygons.
PageFaces page_faces(const VtuGrid& grid, const std::vector<Index>& groups = {});

/// The merged cells by the simplices that they consist of, so that bent ones are seen as they are.
/// Dimensions 1 to 3.
PageFaces page_faces(const Merging& merging);

/// Of how many dimensions the largest cells of a grid are, and each cell.
int cell_dimension(VtuCell type);
int grid_dimension(const VtuGrid& grid);

/// The surface of cells as polygons, of each the cell behind it: polygons themselves, or the faces
/// with one polyhedron. Corners as in the grid.
struct PageRings {
    std::vector<Index> corners;
    std::vector<Index> offsets{0};
    std::vector<std::array<Index, 2>> owners;
};
PageRings page_rings(const VtuGrid& grid);

} // namespace polydec
