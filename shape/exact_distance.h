// SPDX-License-Identifier: MIT
#pragma once

#include "complex/surfaces/glued_surface.h"

#include <span>

namespace polydec {

/// Distance of every vertex from the nearest of the source vertices along a surface of flat
/// triangles, with a length for every edge: the length of a shortest path, exact up to rounding, in
/// the unit of the lengths. The surface may be bounded, one-sided, of several components, of any
/// genus, and branch; edges may be loops. Distances do not depend on how the surface is divided
/// into triangles, so that intrinsic flips keep them.
///
/// Windows run from the sources over the triangles in the order of their distance. Each is a bundle
/// of straight lines through the same triangles; where shortest paths may bend, at vertices with
/// angles above 2 pi or on the boundary, new ones begin. Time and windows grow with the number of
/// triangles to the power 3/2.
/// Source: Mitchell, Mount, Papadimitriou, The discrete geodesic problem, SIAM J. Comput. 16, 1987;
/// Xin, Wang, Improving Chen and Han's algorithm on the discrete geodesic problem, ACM Trans.
/// Graph. 28(4), 2009.
///
/// Throws InvalidInput, naming edge or triangle, for lengths that are none of triangles with area;
/// naming the vertex, for a source that is no vertex, a component without source, and distances out
/// of the range of numbers; SolverFailure if windows grow too many, as on needles.
Vector exact_distance(const Triangles& surface, const Vector& lengths,
                      std::span<const Index> sources);

} // namespace polydec
