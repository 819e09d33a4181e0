// SPDX-License-Identifier: MIT
#pragma once

#include "dec/discretization.h"
#include "dec/forms/cochain.h"
#include "io/pictures/vtu.h"
#include "meshes/polygons.h"

#include <string>

namespace polydec {

/// Throws InvalidInput unless cells of that dimension in that many coordinates can be drawn: both
/// at most 3, and points known.
void check_drawable(int dimension, int ambient_dimension);

/// The cells that carry primal k-forms, as a picture: lines; triangles, quadrangles and polygons
/// (VTK's types 5, 9, 7); or solids, turned outward: tetrahedra and hexahedra (10, 12) if all are
/// such, else polyhedra (42). For k = 0, whose values belong to points, the cells of largest
/// dimension. Points are those of the vertices, in their order. Throws like check_drawable
/// and require_points.
VtuGrid draw_cells(const CellComplex& complex, const Points& points, int k);

/// Adds the values of a primal k-form on P, or of the dual (n-k)-form on the same cells, to what
/// draw_cells made for that k: point data for k = 0, else cell data. Or a vector at each of these
/// cells, a row of two or three numbers. Throws InvalidInput unless there is a row for every
/// k-cell, and like vtu_array.
void add_cochain(VtuGrid& grid, const CellComplex& complex, int k, std::string name,
                 const Eigen::Ref<const DenseMatrix>& values);

/// The same for the cells of a bundle, and a form on them, whose values are taken as they are.
/// Points have the numbers and places of the input; there are those of no cell too, where 0-forms
/// are shown as 0. After intrinsic flips, whose cells cross
/// the input's, it is the input that is shown, with the form as to_input brings it there; dual
/// 1-forms are shown by the primal ones that they are stars of. Of a glued mesh the box is shown,
/// with cells cut along the seams, and the form as form_at_places brings it there. Without words
/// about it the array says of which side and degree it is.
VtuGrid draw_cells(const Discretization& discretization, int k);
void add_form(VtuGrid& grid, const Discretization& discretization, std::string name,
              const Cochain& form, std::string about = {});

/// Adds to what add_form added of a primal 1-form the vectors at the points that it is the work of,
/// by sharp_pp, as the array NAME_vector: in units of the values over length, 0 at points of no
/// cell. False, and nothing is added, for other forms and where the mesh has no sharp.
bool add_vectors(VtuGrid& grid, const Discretization& discretization, const std::string& name,
                 const Cochain& form);

/// The cells that these draw: the merged ones, or those of the input where edges were flipped.
Merging drawn_cells(const Discretization& discretization);

/// The merged 2-cells of a surface as polygons; of a bundle with the numbers and places of the
/// input, and after intrinsic flips those of draw_overlay.
PolygonMesh polygon_mesh(const Merging& merging, const Points& points);
PolygonMesh polygon_mesh(const Discretization& discretization);

} // namespace polydec
