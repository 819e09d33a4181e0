// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/polygons.h"

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace polydec {

/// The facets of a convex cell, by the places of their corners. Each is oriented so that its
/// simplices, appended to an interior vertex, have the orientation of the cell. A simplex lists
/// none.
struct CellShape {
    struct Facet {
        std::shared_ptr<const CellShape> shape;
        std::vector<std::size_t> corners;
    };
    int dimension = 0;
    std::vector<Facet> facets = {};
};

/// The shape of cells with this many corners: simplices, polygons, pyramids (5 corners, the last is
/// the apex), wedges, hexahedra and other prisms (6, 8, 10, 12; first the base, then the corners
/// over it). Null if there is none. Dimension 0 to 3.
const CellShape* cell_shape(int dimension, std::size_t corners);

/// The n-cube: bit k of a corner's number is its coordinate along axis k. Its facets are not
/// oriented. Throws InvalidInput unless n is 1 to 30.
CellShape cube_shape(int n);

/// Appends the simplices of a cell: cones from the cell's smallest vertex over the simplices of the
/// facets without it, which are split in the same way. So cells split a common face equally. A cell
/// with coinciding corners, such as a wedge written as a hexahedron, has fewer simplices. Adds no
/// vertices and leaves simplices unchanged. Source: the pulling triangulation, Lee, Regular
/// triangulations of convex polytopes, 1991.
void pull_cell(const CellShape& shape, std::span<const Index> corners,
               std::vector<Index>& simplices);

/// Splits cells of one dimension, possibly mixed polygons or solids, into simplices that keep
/// orientation, vertex numbers and tags: polygons as in split_polygons, solids as in pull_cell,
/// with positive volume in R^n. Warnings count only solids that were split or had coinciding
/// corners. Throws InvalidInput, naming the cell, for a number of corners without a shape, and like
/// split_polygons.
Mesh split_cells(PolygonMesh cells, int dimension);

/// The simplices of tagged cells of one dimension, from pull_cell; tag 0 means none. Omits cells
/// without a shape.
TaggedSimplices pull_tagged(const PolygonMesh& cells, int dimension);

} // namespace polydec
