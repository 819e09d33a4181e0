// SPDX-License-Identifier: MIT
#pragma once

#include "dec/metric/geometry.h"

#include <vector>

namespace polydec {

/// Whether flat n-simplices can be pieces of their neighbors' cells: only in solids in space. A
/// flat triangle has its corners on a line, which meets a circle in only two points. In dimensions
/// four and higher, facets of a flat simplex may be flat as well, without circumcenter. In curved
/// complexes, and if only lengths are known, there is no way to decide whether a simplex lies on
/// the sphere of another.
bool can_take_flat_simplices(int dimension, Index ambient_dimension);

/// Marks n-simplices with a height of at most 1/100 of the shortest edge at their corners: their
/// circumcenters are meaningless. Empty if there are none, or if they could not be used. The
/// shortest edge includes edges of the neighbors. So thin layers, whose simplices are all low, are
/// not flat.
std::vector<bool> flat_simplices(const Geometry& geometry);

/// The same, with the shortest edge at each vertex given, e.g. from a larger complex.
std::vector<bool> flat_simplices(const Geometry& geometry, const Vector& shortest);

/// The shortest edge at each vertex; length.
Vector shortest_edges(const Pieces& complex, const CellVolumes& volumes);

} // namespace polydec
