// SPDX-License-Identifier: MIT
#pragma once

#include "complex/simplicial_complex.h"

#include <vector>

namespace polydec {

/// Where the boundary of a complex lies upon itself; vertices are 0-simplices of the complex.
struct BoundaryContacts {
    std::vector<Index> coincident; ///< all but the first vertex of each place

    /// Facets of the boundary that are at the place of no other, by the first vertex of each place:
    /// ascending corners, in lexicographic order.
    Simplices facets;
    std::vector<std::vector<Index>> hanging; ///< of each of them the vertices in it, ascending
    Index misfits = 0;                       ///< of them those with their centroid in another one
};

/// Vertices at most this far apart are at one place. The points have a row for each 0-simplex.
BoundaryContacts boundary_contacts(const SimplicialComplex& complex, const Points& points,
                                   double length);

} // namespace polydec
