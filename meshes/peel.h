// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

namespace polydec {

/// The mesh without the flat cells that meshers make where points of the boundary are a little off
/// its planes: simplices over nearly collinear or coplanar points of the hull, which lie on no
/// sphere of a neighbor and so can never be merged. What is left out changes the region by as much
/// as the points are off, and is told in the mesh's warnings.
///
/// A cell is flat if a height is at most 1/100 of the shortest edge at its corners. It is taken
/// away if some of its facets, but not n, belong to no other cell and the face that its other
/// facets share does not lie on the boundary: so the region stays what it was, but for its skin,
/// and no vertex is lost. Cells are taken in rounds, in each none that share a vertex, first those
/// whose corners come first in space; so the result does not depend on numbers.
/// Time O(cells log cells) and as many rounds over the flat cells as these lie upon each other.
/// Throws InvalidInput like tidy, of which it keeps the flat cells, and unless N = n >= 2.
Mesh peeled(Mesh mesh);

} // namespace polydec
