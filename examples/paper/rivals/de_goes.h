// SPDX-License-Identifier: MIT
#pragma once

#include "examples/paper/rivals/polygon_laplacian.h"
#include "meshes/polygons.h"

namespace polydec::paper {

/// The Laplacian of de Goes, Butts and Desbrun: the sum over the faces of
///     D^T (|a| U^T U + lambda P^T P) D,   P = 1 - V U,
/// D the differences along the edges, a the area vector with direction n,
/// U = [n]x (B - 1 c^T)^T / |a| the sharp, which maps differences to a gradient (the rows of B
/// the edges' midpoints, c the mean of the corners), and V = E (1 - n n^T) the flat, which maps a
/// vector to its differences along the edges E. P projects to the kernel of U. The mass is
/// diagonal: a face gives each of its m corners |a| / m.
///
/// lambda = 1 is the value that the authors recommend. On triangles P D = 0, and the
/// stiffness is the cotangent matrix with weights (cot + cot) / 2. Stiffness positive semidefinite;
/// for lambda > 0 its kernel is the functions constant on each component. Linear functions on
/// planar meshes are harmonic at interior vertices. For non-planar faces the total mass is the sum
/// of |a|. Does not depend on orientation.
///
/// Source: de Goes, Butts and Desbrun 2020, Discrete differential operators on polygonal meshes.
/// Throws InvalidInput like check_surface, and for a lambda that is negative or not finite.
PolygonLaplacian de_goes(const PolygonMesh& mesh, double lambda = 1.0);

} // namespace polydec::paper
