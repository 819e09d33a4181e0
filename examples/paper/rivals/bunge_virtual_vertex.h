// SPDX-License-Identifier: MIT
#pragma once

#include "examples/paper/rivals/polygon_faces.h"
#include "examples/paper/rivals/polygon_laplacian.h"

namespace polydec::paper {

/// The weights w of a face's virtual vertex x = sum w_i x_i; they sum to 1. x minimizes the sum of
/// the squared areas of its triangles with the edges. Among all weights for x, w has the least
/// norm. x is the centroid on a triangle; weights are equal on a regular polygon, and can be
/// negative.
/// The weights jump where a polygon stops being planar, since fewer weights give x then. A polygon
/// counts as planar up to 1e-10 of its size; a polygon from a file with seven digits does not.
/// Source: Bunge, Herholz, Kazhdan and Botsch 2020.
Vector virtual_vertex_weights(const Polygon& polygon);

/// P: maps values at vertices to values at vertices and virtual vertices; face f has row
/// f + number of vertices. Rows sum to 1.
SparseMatrix prolongation(const PolygonMesh& mesh);

/// The Laplacian of Bunge, Herholz, Kazhdan and Botsch: P^T S P and P^T M P, where every face is a
/// fan of triangles around its virtual vertex, S is their cotangent stiffness and M the mass of
/// piecewise linear functions (area / 6 and / 12). The mass is not diagonal; its row sums are the
/// lumped mass.
///
/// On triangles both are the matrices of piecewise linear elements; the stiffness has weights
/// (cot + cot) / 2. Stiffness positive semidefinite, kernel the functions constant on each
/// component, mass positive definite. Linear functions on planar meshes are harmonic at interior
/// vertices, if every face is star-shaped with respect to its virtual vertex. Otherwise triangles
/// overlap, the total mass exceeds the area, and linear functions are not harmonic. Does not depend
/// on orientation.
///
/// Source: Bunge, Herholz, Kazhdan and Botsch 2020, Polygon Laplacian made simple.
/// Throws InvalidInput like check_surface, and if a triangle has at most 1e-12 of its longest
/// edge squared as area.
PolygonLaplacian bunge_virtual_vertex(const PolygonMesh& mesh);

} // namespace polydec::paper
