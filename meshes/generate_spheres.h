// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

namespace polydec {

/// Unit sphere of `meridians` times `bands`: triangles at the poles, and between them planar
/// trapezoids, each split by a diagonal. Outward orientation. `bands` counts from pole to pole,
/// so there are bands - 1 parallels. The north pole (0, 0, 1) is vertex 0, the south pole the last.
/// Throws InvalidInput unless meridians >= 3, bands >= 2, and sizes fit into 32 bits.
Mesh uv_sphere(int meridians, int bands);

/// Unit sphere from the icosahedron, class I: every face is cut into frequency^2 equal triangles,
/// and their corners are projected radially to the sphere. 10 frequency^2 + 2 vertices, 20
/// frequency^2 triangles, outward orientation. Frequency 2^s has the counts of s subdivisions, but
/// slightly different points. Reflections in the coordinate planes and cyclic exchanges of the axes
/// map the points to each other to the last bit.
/// Throws InvalidInput unless frequency >= 1 and sizes fit into 32 bits.
Mesh icosphere(int frequency);

} // namespace polydec
