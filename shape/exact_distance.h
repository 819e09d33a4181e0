// SPDX-License-Identifier: MIT
#pragma once

#include "complex/surfaces/glued_surface.h"

#include <span>

namespace polydec {

/// Distance of every vertex from the nearest source vertex along a surface of flat triangles with
/// one length per edge: the length of a shortest path, exact up to rounding, in the unit of the
/// lengths. The surface may be bounded, one-sided, branching, of several components and of any
/// genus; edges may be loops. Distances do not depend on the triangulation, so intrinsic flips
/// preserve them.
///
/// Windows run from the sources over the triangles in order of distance. Each is a bundle of
/// straight lines through the same triangles. New windows begin where shortest paths may bend: at
/// vertices with angles above 2 pi or on the boundary. Time and windows grow with the number of
/// triangles to the power 3/2.
/// Source: Mitchell, Mount, Papadimitriou, The discrete geodesic problem, SIAM J. Comput. 16, 1987;
/// Xin, Wang, Improving Chen and Han's algorithm on the discrete geodesic problem, ACM Trans.
/// Graph. 28(4), 2009.
///
/// Throws InvalidInput, naming edge or triangle, unless the lengths form triangles with area;
/// naming the vertex, for a source that is not a vertex, a component without source, and distances
/// that overflow; SolverFailure if there are too many windows, as on needles.
Vector exact_distance(const Triangles& surface, const Vector& lengths,
                      std::span<const Index> sources);

} // namespace polydec
