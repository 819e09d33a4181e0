// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

namespace polydec {

/// The mesh without flat boundary cells, which mesh generators make if boundary points are slightly
/// off a plane: simplices over nearly collinear or coplanar points of the hull. They lie on no
/// neighbor's sphere, so they cannot be merged. Removing them changes the region by as much as the
/// points are off; the mesh's warnings report it.
///
/// A cell is flat if a height is at most 1/100 of the shortest edge at its corners. It is removed
/// if some of its facets, but not n, belong to no other cell, and the face shared by its other
/// facets is not on the boundary. So the region stays what it was, except for its skin, and no
/// vertex is lost. Cells are removed in rounds, none of which has two cells with a common vertex,
/// in spatial order of their corners; so results do not depend on numbers. Time O(cells log cells),
/// and one round per layer of flat cells. Throws InvalidInput like tidy, whose flat cells it keeps,
/// and unless N = n >= 2.
Mesh peeled(Mesh mesh);

} // namespace polydec
