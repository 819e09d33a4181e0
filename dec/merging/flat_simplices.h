// SPDX-License-Identifier: MIT
#pragma once

#include "dec/metric/geometry.h"

#include <vector>

namespace polydec {

/// Whether flat n-simplices can be pieces of their neighbors' cells: those of solids in space. A
/// triangle that is flat has corners on a line, which meets a circle in two points only; in four
/// dimensions and more the facets of a flat simplex can be flat themselves, and then have no
/// circumcenter either. In curved complexes, and where only lengths are known, it cannot be said
/// whether a simplex lies on the sphere of another.
bool can_take_flat_simplices(int dimension, Index ambient_dimension);

/// Which n-simplices have a height of at most 1/100 of the shortest edge at their corners; empty
/// where none are, or where they would be of no use. Their circumcenters mean nothing. The edges
/// looked at are those of the neighbors too: so thin layers, all of whose simplices are low, are
/// not flat.
std::vector<bool> flat_simplices(const Geometry& geometry);

/// The same, where the shortest edge at each vertex is known better than from these simplices.
std::vector<bool> flat_simplices(const Geometry& geometry, const Vector& shortest);

/// The shortest edge at each vertex; length.
Vector shortest_edges(const Pieces& complex, const CellVolumes& volumes);

} // namespace polydec
