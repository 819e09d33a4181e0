// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

namespace polydec {

/// Goldberg polyhedron of class I inscribed in the unit sphere: 12 pentagons and
/// 10 frequency^2 - 10 hexagons, all planar with corners on the sphere, hence concyclic, each
/// fanned into triangles that are oriented outward. 20 frequency^2 vertices. Frequency 1 is the
/// dodecahedron. Planes hold to about 1e-15.
///
/// Corners start over the midpoints of the icosphere's triangles. Gauss-Newton steps of least norm
/// move them on the sphere until every face is planar; this keeps the icosahedral symmetry (to
/// rounding). Takes about a second for frequency 32, ten for 64.
/// Throws InvalidInput unless frequency is 1 .. 64; SolverFailure if the iteration does not
/// converge.
Mesh goldberg(int frequency);

} // namespace polydec
