// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/polygons.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace polydec {

/// How the corners of a convex cell bound it: the places of the corners of each facet, which is
/// oriented so that its simplices, behind a vertex inside, have the orientation of the cell. A
/// simplex has none listed.
struct CellShape {
    struct Facet {
        std::shared_ptr<const CellShape> shape;
        std::vector<std::size_t> corners;
    };
    int dimension = 0;
    std::vector<Facet> facets = {};
};

/// The shape of cells with so many corners: simplices, polygons, pyramids (5 corners, the last is
/// the apex), wedges, hexahedra and other prisms (6, 8, 10, 12; first the base, then what lies over
/// it). Null if there is none. Dimension 0 to 3.
const CellShape* cell_shape(int dimension, std::size_t corners);

/// The n-cube, n >= 1: bit k of the number of a corner tells where it lies along axis k. Its facets
/// are not oriented.
CellShape cube_shape(int n);

/// Appends the simplices of a cell: cones from the cell's smallest vertex over the simplices of the
/// facets without it, which are split in the same way. So cells with a common face split it
/// equally. A cell whose corners coincide in part, as those of a wedge written as a hexahedron do,
/// has fewer simplices. No vertices are added, and simplices stay as they are.
/// Source: the pulling triangulation, Lee, Regular triangulations of convex polytopes, 1991.
void pull_cell(const CellShape& shape, std::span<const Index> corners,
               std::vector<Index>& simplices);

/// Splits cells of one dimension, polygons and solids mixed as they may be, into simplices that
/// keep orientation, vertex numbers and tags: polygons as split_polygons does, solids as pull_cell
/// does, and with positive volume in R^n. Warnings count solids that were split or had coinciding
/// corners alone. Throws InvalidInput, naming the cell, for a number of corners without a shape,
/// and like split_polygons.
Mesh split_cells(PolygonMesh cells, int dimension);

/// The simplices of cells that bound others and have a tag, by pull_cell; tags of 0 are none. Cells
/// without a shape are left out.
TaggedSimplices pull_tagged(int dimension, const std::vector<Index>& corners,
                            const std::vector<Index>& offsets, const std::vector<Index>& tags);

} // namespace polydec
