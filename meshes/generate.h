// SPDX-License-Identifier: MIT
#pragma once

#include "meshes/mesh.h"

#include <cstdint>
#include <vector>

namespace polydec {

/// The rectangle [0, width] x [0, height] in nx times ny equal rectangles, each split by the
/// diagonal from its lower left to its upper right corner. All triangles are counterclockwise.
/// Vertex (i, j) at (i width / nx, j height / ny) has the number i (ny + 1) + j.
/// Throws InvalidInput unless nx, ny >= 1, lengths are positive, sizes fit into 32 bits.
Mesh grid(int nx, int ny, double width = 1.0, double height = 1.0);

/// The unit square in rows of hexagons, `columns` >= 2 to a row, cut at the boundary and fanned
/// into counterclockwise triangles. The number of rows is the odd one that makes the hexagons
/// nearly regular. The row heights put the corners of every polygon on a circle, including the half
/// hexagons and pentagons at the boundary. Half hexagons at the left and right boundary have their
/// circumcenters on it, so their boundary edges have zero dual length. Throws InvalidInput unless
/// columns >= 2 and sizes fit into 32 bits.
Mesh hexagons(int columns);

/// The unit square in 2 `rows` rows of acute triangles, all counterclockwise: every circumcenter
/// lies strictly inside its triangle, so there is nothing to merge and all duals are positive.
/// Throws InvalidInput unless rows >= 2 and sizes fit into 32 bits.
Mesh well_centered(int rows);

/// Kuhn's (Freudenthal's) triangulation of a box in R^n, n = 1 .. 12: cells[k] equal boxes along
/// axis k, each split into n! simplices around its diagonal. All n-simplices have positive
/// determinant. Vertices are numbered lexicographically by their coordinates.
/// Without lengths the box is the unit cube.
/// Throws InvalidInput unless every count is >= 1, every length positive, sizes fit into 32 bits.
Mesh kuhn(const std::vector<int>& cells, const std::vector<double>& lengths = {});

/// The same for the unit cube of R^n, with equally many cells along every axis.
Mesh kuhn(int n, int cells_per_side);

/// The same boxes, each split at random into n! simplices. Every face of a box is a cone over its
/// facets that miss one of its corners; a random order of all vertices selects that corner, so
/// neighbors agree on shared faces. Merging gives the same grid of boxes as kuhn. The same seed
/// gives the same mesh on every machine. Throws like kuhn.
Mesh split_boxes(const std::vector<int>& cells, const std::vector<double>& lengths = {},
                 std::uint64_t seed = 1);

/// Body-centered cubic lattice in the unit cube: corners and centers of cells^3 cubes. Four
/// congruent tetrahedra surround each inner square. Behind each boundary square is half of that, an
/// exactly cospherical pyramid split by the square's diagonal. 12 tetrahedra a cube, all of
/// positive determinant. Throws InvalidInput unless cells >= 1 and sizes fit into 32 bits.
Mesh bcc(int cells);

/// The same in a box with cells[k] cubes of that edge along axis k. Unlike Kuhn's simplices,
/// lattice simplices need cubes. Also throws InvalidInput unless there are three counts and the
/// edge is positive.
Mesh bcc(const std::vector<int>& cells, double edge = 1.0);

/// Face-centered cubic lattice in the unit cube: corners and face centers of cells^3 cubes. Its
/// cells are regular tetrahedra and octahedra; the octahedra are split into four around a diagonal:
/// around x in the middle of a cube, around the cube's edge otherwise. 24 tetrahedra a cube, all of
/// positive determinant; facets in the boundary have zero dual length. Throws InvalidInput unless
/// cells >= 1 and sizes fit into 32 bits.
Mesh fcc(int cells);

/// The same in a box with cells[k] cubes of that edge along axis k. Throws like bcc of a box.
Mesh fcc(const std::vector<int>& cells, double edge = 1.0);

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

/// Torus around the z axis: `major` times `minor` planar trapezoids, each split by a diagonal.
/// Outward orientation. Vertex (i, j), i around the axis, has the number i minor + j.
/// Throws InvalidInput unless major, minor >= 3, 0 < minor_radius < major_radius.
Mesh torus(int major, int minor, double major_radius = 1.0, double minor_radius = 0.4);

/// Moebius strip in R^3 with the center line of radius 1: `around` times `across` quads, split;
/// not orientable. Throws InvalidInput unless around >= 3, across >= 1, 0 < width < 2.
Mesh moebius(int around, int across, double width = 0.6);

/// A machine part, closed, genus 1, oriented outward: a round flange (radius 1, 0.2 thick) with a
/// hub, beveled by a cone, and a bore of radius 0.3 along the z axis. A stepped profile is
/// revolved in `segments` steps, so that every face is a rectangle or an isosceles trapezoid,
/// nearly square, split by a diagonal. Throws InvalidInput unless segments >= 3.
Mesh flange(int segments);

struct ClusterOptions {
    int dimension = 3;         ///< n = 2 .. 6
    int cells_per_side = 6;    ///< boxes along each axis; one random point in each
    int spheres = 1;           ///< empty spheres
    int points_on_sphere = 40; ///< random, evenly spread; n + 1 or more
    double radius = 0.25;      ///< of the spheres, below 1/2
    std::uint64_t seed = 1;    ///< gives the same mesh on every machine
};

/// Clusters of cospherical points in a random Delaunay mesh of the unit cube. The spheres do not
/// meet, have points on them and none inside; merging the simplices in each gives one Delaunay cell
/// with that many corners. Every box of a grid holds a random point, unless it is too near to a
/// sphere; the boundary has the points of the grid. Throws InvalidInput, naming the option and its
/// range, or if the spheres do not fit.
Mesh sphere_clusters(const ClusterOptions& options = {});

/// The lattice D4 in the unit cube of R^4: the points at multiples of 1 / (2 cells) with an even
/// sum of multiples. Its Delaunay cells are regular 16-cells, 24 to cells^4 cubes. One is around
/// the center of each small cube, and one around each omitted point, cut off at the boundary. Each
/// is split into 8 simplices around a diagonal; facets in the boundary have zero dual length. 192
/// simplices a cube, all of positive determinant.
/// Throws InvalidInput unless cells >= 1 and sizes fit into 32 bits.
Mesh d4(int cells);

/// The same in a box with cells[k] cubes of that edge along axis k; needs four counts.
/// Throws like bcc of a box.
Mesh d4(const std::vector<int>& cells, double edge = 1.0);

} // namespace polydec
