// SPDX-License-Identifier: MIT
#pragma once

#include "tests/support/read_golden.h"
#include "tests/support/test.h"

namespace polydec {

/// Number of distinct faces of each dimension.
std::vector<Index> face_counts(const Mesh& mesh);
Index euler_characteristic(const Mesh& mesh);

/// Smallest determinant of the edge vectors over all cells; n = N.
double least_determinant(const Mesh& mesh);

/// Volume that a closed surface in space encloses; positive if it is oriented outward.
double enclosed_volume(const Mesh& mesh);

/// Numbers of facets by how often they occur with the orientation +, and with -.
struct FacetTally {
    Index boundary = 0;  ///< in one cell
    Index coherent = 0;  ///< in two cells, once each way
    Index clashing = 0;  ///< in two cells, twice the same way
    Index branching = 0; ///< in more
};
FacetTally tally_facets(const Mesh& mesh);

/// For each vertex of a the vertex of b within the distance, or -1. N and sizes are equal.
std::vector<Index> matching_vertices(const Mesh& a, const Mesh& b, double distance);

/// The volume of each cell.
Vector cell_volumes(const Mesh& mesh);

/// The cells as a sorted list of ascending vertex lists.
std::vector<std::vector<Index>> sorted_rows(const Simplices& cells);

/// Whether points (within 1e-12) and cells are the same up to numbering.
bool same_geometry(const Mesh& a, const Mesh& b);

/// Polygons, or the faces of cells, from lists of their corners.
PolygonMesh mesh_of(const Points& points, const std::vector<std::vector<Index>>& cells);

} // namespace polydec
