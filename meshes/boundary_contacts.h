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

/// Vertices at most `length` apart coincide. The points have a row for each 0-simplex.
BoundaryContacts boundary_contacts(const SimplicialComplex& complex, const Points& points,
                                   double length);

} // namespace polydec
