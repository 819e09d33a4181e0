// SPDX-License-Identifier: MIT
#pragma once

#include "complex/cell_complex.h"

namespace polydec {

/// Which cells of each degree 0..n belong to something: marks[k][s].
using CellMarks = std::vector<std::vector<bool>>;

/// Throws InvalidInput, naming the degree, unless there is a mark for each cell.
void check_marks(const CellComplex& complex, const CellMarks& marks);

/// Marks with each cell all its faces, also those that cancel in its row of d. Linear time. Throws
/// like check_marks.
void mark_faces(const CellComplex& complex, CellMarks& marks);

/// The cells of the boundary: facets with one coface, and their faces of every degree.
CellMarks boundary_cells(const CellComplex& complex);

struct Components {
    Index count = 0;
    std::vector<Index> of_vertex; ///< 0..count-1, in the order of first vertices; -1 if in none
};

/// Connected components; cells are connected by shared vertices.
Components components(const CellComplex& complex);

/// Connected components of the boundary; vertices off the boundary belong to none.
Components boundary_components(const CellComplex& complex);

} // namespace polydec
