// SPDX-License-Identifier: MIT
#pragma once

#include "complex/simplicial_complex.h"

#include <vector>

namespace polydec {

/// Places where the boundary of a complex touches itself, by the complex's vertex numbers.
struct BoundaryContacts {
    std::vector<Index> coincident; ///< all but the first vertex at each place

    /// Boundary facets that coincide with no other, by the first vertex of each place: ascending
    /// corners, in lexicographic order.
    Simplices facets;
    std::vector<std::vector<Index>> in_facets; ///< for each facet, the vertices in it, ascending
    std::vector<Index> hanging;                ///< all of these, ascending, each once
    Index misfits = 0;                         ///< facets with their centroid in another one
};

/// Facets with one cell: their corners, the vertex of the cell that is not theirs, and a number of
/// the cell.
struct OpenFacets {
    Simplices corners;
    std::vector<Index> opposite = {}, cells = {};
    std::vector<Index> numbers = {}; ///< of the vertices, for results; ascending
};
OpenFacets open_facets(const SimplicialComplex& complex);

/// Vertices at most `length` apart coincide. The points have a row for each vertex.
BoundaryContacts boundary_contacts(const OpenFacets& facets, const Points& points, double length);

} // namespace polydec
