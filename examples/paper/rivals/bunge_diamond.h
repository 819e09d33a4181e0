// SPDX-License-Identifier: MIT
#pragma once

#include "examples/paper/rivals/polygon_laplacian.h"
#include "meshes/polygons.h"

namespace polydec::paper {

/// The diamond Laplacian of Bunge, Botsch and Alexa: P^T G^T A G P and P^T M P.
///
/// P maps values at vertices to values at vertices and virtual vertices, one per face, as in
/// bunge_virtual_vertex. An edge from a to b and the virtual vertices l and r of the faces to its
/// left and right span a diamond, unfolded around the edge into a plane. The gradient g, a row of G
/// for each of two coordinates, satisfies
///     g . (b - a) = u_b - u_a,   g . (l - r) = u_l - u_r,
/// and A has its area. At a boundary edge the diamond is half: a triangle, r the edge's midpoint
/// with the mean of u_a and u_b, g the gradient of the linear function. M is diagonal: a diamond
/// gives a quarter of its area to each corner, half a diamond a third. The mass is not diagonal;
/// its row sums are the lumped mass. (The authors' program does not unfold, but projects to the
/// plane of the first triangle: a change of second order in the angle between the triangles, which
/// depends on their order.)
///
/// Stiffness positive semidefinite, kernel the functions constant on each component, mass positive
/// definite. Linear functions on planar meshes are harmonic at interior vertices. On triangles it
/// is *not* the cotangent Laplacian but a wider stencil: it couples all corners of two faces with a
/// common edge. Does not depend on orientation.
///
/// Source: Bunge, Botsch and Alexa 2021, The diamond Laplace for polygonal and polyhedral meshes.
/// Throws InvalidInput like check_surface, and, naming the edge, if more than two faces meet there
/// or its diamond has no area, as can happen with faces that are not star-shaped.
PolygonLaplacian bunge_diamond(const PolygonMesh& mesh);

} // namespace polydec::paper
