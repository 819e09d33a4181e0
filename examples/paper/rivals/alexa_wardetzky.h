// SPDX-License-Identifier: MIT
#pragma once

#include "examples/paper/rivals/polygon_laplacian.h"
#include "meshes/polygons.h"

namespace polydec::paper {

/// The Laplacian of Alexa and Wardetzky: the sum over the faces of
///     D^T (B B^T / |a| + lambda C C^T) D,
/// D the differences along the edges, the rows of B the edges' midpoints, a the area vector. The
/// columns of C are an orthonormal basis of the kernel of E^T, E the edge vectors projected along
/// a. The mass is diagonal: a face gives each of its n corners |a| / n.
///
/// lambda weights the part of a polygon that the first term misses. The authors leave it free;
/// later comparisons take 2 (code to Bunge et al. 2020 and 2021). On triangles it has no effect,
/// and the stiffness is the cotangent matrix with weights (cot + cot) / 2. Stiffness positive
/// semidefinite; for lambda > 0 its kernel is the functions constant on each component. Linear
/// functions on planar meshes are harmonic at interior vertices. For non-planar faces the total
/// mass is the sum of |a|. Does not depend on orientation.
///
/// Source: Alexa and Wardetzky 2011, Discrete Laplacians on general polygonal meshes.
/// Throws InvalidInput like check_surface, and for a lambda that is negative or not finite.
PolygonLaplacian alexa_wardetzky(const PolygonMesh& mesh, double lambda = 2.0);

} // namespace polydec::paper
