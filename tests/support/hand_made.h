// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <cstdint>
#include <functional>

namespace polydec::test {

/// Points and simplices from nested lists.
Mesh made_of(std::vector<std::vector<double>> points, std::vector<std::vector<Index>> simplices);

/// Both meshes, which do not touch: the vertices of the second follow those of the first.
Mesh united(const Mesh& first, const Mesh& second);

/// The mesh without the simplices whose centroid (mean of the vertices) is in the given set.
Mesh without(const Mesh& mesh, const std::function<bool(const Vector&)>& centroid_is_left_out);

/// The facets that belong to one simplex, oriented as its boundary. Vertex numbers stay.
Mesh boundary_of(const Mesh& mesh);

/// The mesh under x -> scale A x + shift.
Mesh transformed(Mesh mesh, const DenseMatrix& A, double scale = 1.0, double shift = 0.0);

/// A random rotation or reflection of R^N.
DenseMatrix random_isometry(Index N, unsigned seed);

/// Triangles in space, a column for each corner; equal points are one vertex.
Mesh welded(const std::vector<Eigen::Matrix3d>& triangles);

/// Copies of a page in the plane, each turned by an angle about the side on which the first
/// coordinate is 0, and joined there; that side becomes the third axis.
Mesh book_of(const Mesh& page, const std::vector<double>& angles);

/// Points within the unit cube moved at random; its boundary stays.
Mesh shaken_inside(Mesh mesh, double amplitude, std::uint64_t seed = 1);

/// Two triangles on the edge from (0,0) to (2,0), their apices at these heights over (1,0).
Mesh kite(double up, double down);

Mesh polygon_curve();          ///< closed, n = 1 in R^3
Mesh theta_graph();            ///< n = 1: three arcs between two vertices
Mesh two_components();         ///< a sphere beside a torus
Mesh obtuse_planar();          ///< sheared and stretched grid, strongly perturbed
Mesh obtuse_solid();           ///< Kuhn grid, sheared and strongly perturbed
Mesh projective_plane();       ///< 6 vertices: the unit vectors of R^6
Mesh klein_bottle();           ///< in R^4
Mesh genus_two();              ///< boundary of a block of cubes with two holes
Mesh hollow_cube();            ///< 3^3 cubes without the middle one
Mesh clifford_torus();         ///< in R^4, of congruent acute triangles: every dual is a hexagon
Mesh cubical_torus(int n);     ///< n-torus of 4^n cubes in R^(2n), each split like Kuhn's
Mesh tilted_tetrahedra();      ///< three tetrahedra on one triangle in R^4
Mesh pinched();                ///< two tetrahedra that share an edge, and a third at a vertex
Mesh with_isolated_vertices(); ///< a grid whose vertices have the odd numbers
Mesh triangle_soup();          ///< triangles in R^3 that share nothing
Mesh annulus(int segments, int layers = 1); ///< rectangles between the radii 1 and 2
Mesh spherical_ring();    ///< 8 tetrahedra around a hole, cospherical up to rounding
Mesh handle_and_cavity(); ///< 23 cospherical 5-simplices with the Euler number of a ball

} // namespace polydec::test
