// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization/discretization.h"
#include "dec/forms/cochain.h"
#include "io/pictures/vtu.h"
#include "meshes/level_sets.h"
#include "meshes/polygons.h"

#include <string>

namespace polydec {

/// Throws InvalidInput unless cells of this dimension in this many coordinates can be drawn: both
/// at most 3, and points known.
void check_drawable(int dimension, int ambient_dimension);

/// The cells that carry primal k-forms, as a picture: lines; triangles, quadrangles and polygons
/// (VTK's types 5, 9, 7); or solids with outward faces: tetrahedra and hexahedra (10, 12) if all
/// are of these types, else polyhedra (42). For k = 0, with values at points, the cells of largest
/// dimension. Points are the vertices, in their order. Throws like check_drawable and
/// require_points.
VtuGrid draw_cells(const CellComplex& complex, const Points& points, int k);

/// Adds the values of a primal k-form on P, or of the dual (n-k)-form on the same cells, to the
/// picture from draw_cells for that k: point data for k = 0, else cell data. Rows of two or three
/// numbers are vectors at these cells. Throws InvalidInput unless there is a row for every k-cell,
/// and like vtu_array.
void add_cochain(VtuData& picture, const CellComplex& complex, int k, std::string name,
                 const Eigen::Ref<const DenseMatrix>& values);

/// The same for the cells of a discretization. Points have the numbers and places of the input,
/// including points of no cell. After intrinsic flips, whose cells cross the input's, the picture
/// shows the input; for a glued mesh the box, with cells cut along the seams.
VtuGrid draw_cells(const Discretization& discretization, int k);

/// The values of forms of one kind (columns) on the cells that the picture shows, in their order:
/// unchanged, and 0 at points of no cell; after flips mapped by to_input, where a dual 1-form
/// star u is drawn as u; on a glued mesh mapped by form_at_places.
DenseMatrix drawn_values(const Discretization& discretization, Side side, int degree,
                         const Eigen::Ref<const DenseMatrix>& columns);

/// Adds the proxy vectors of a form at the points, by vectors_at_vertices, to the picture from
/// draw_cells, as the array NAME_vector: 0 at points of no cell. Returns false, and adds nothing,
/// for forms without such vectors and if the mesh has no sharp.
bool add_vectors(VtuData& picture, const Discretization& discretization, const std::string& name,
                 const Cochain& form);

/// The cells in these pictures: the merged ones, or the input's if edges were flipped.
Merging drawn_cells(const Discretization& discretization);

/// The merged 2-cells of a surface as polygons; for a discretization with the numbers and places of
/// the input, and after intrinsic flips from draw_overlay.
PolygonMesh polygon_mesh(const Merging& merging, const Points& points);
PolygonMesh polygon_mesh(const Discretization& discretization);

/// The input's triangles cut along the flipped edges, as polygons. For each piece the array `cell`
/// holds the merged cell, `triangle` the input triangle, numbered as in the complex. Points are the
/// vertices, then the crossings of edges. Throws like overlay and check_drawable.
VtuGrid draw_overlay(const Discretization& discretization);

/// The merged cells of largest dimension, with the array `tag` if they have tags; after intrinsic
/// flips the pieces of draw_overlay, each with the tag of its cell. Throws like both.
VtuGrid draw_mesh(const Discretization& discretization);

/// The level sets of a primal 0-form, linear on the input's simplices, with their numbers and at
/// the places of the input; without orientation. Throws like level_sets, and InvalidInput for other
/// forms, which have no values at vertices.
LevelSets level_sets(const Discretization& discretization, const Cochain& form,
                     const Vector& levels);

/// Draws level sets as points, lines, triangles or tetrahedra. Cell data are the levels, under this
/// name, and `simplex`, the simplex that contains each. Throws InvalidInput above three dimensions.
VtuGrid draw_levels(const LevelSets& sets, const Vector& levels, std::string name);

} // namespace polydec
