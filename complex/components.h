// SPDX-License-Identifier: MIT
#pragma once

#include "complex/cell_complex.h"

namespace polydec {

/// Marks some cells of each degree 0..n: marks[k][s].
using CellMarks = std::vector<std::vector<bool>>;

/// Marks none of the cells of a complex.
CellMarks no_marks(const CellComplex& complex);

/// Throws InvalidInput, naming the degree, unless there is one mark per cell.
void check_marks(const CellComplex& complex, const CellMarks& marks);

/// Marks all faces of every marked cell, including faces that cancel in its row of d. Linear time.
/// Throws like check_marks.
void mark_faces(const CellComplex& complex, CellMarks& marks);

/// A facet with one coface.
struct BoundaryFacet {
    Index facet, cell; ///< numbers of the (n-1)-cell and of the n-cell beside it
    int outward;       ///< 1 if the facet is oriented as the boundary of the n-cell is, else -1
};

/// The facets of the boundary, in the order of their numbers. Linear time.
std::vector<BoundaryFacet> boundary_facets(const CellComplex& complex);

/// Marks the cells of the boundary: facets with one coface, and their faces of every degree.
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
