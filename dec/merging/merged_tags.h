// SPDX-License-Identifier: MIT
#pragma once

#include "complex/merging.h"
#include "complex/simplicial_complex.h"
#include "meshes/mesh.h"

#include <string>
#include <vector>

namespace polydec {

/// Of each n-simplex of the complex the tag of its row in the input; or empty, if `tags` is.
/// Throws InvalidInput for another number of tags.
std::vector<Index> tags_of_cells(const SimplicialComplex& complex, const std::vector<Index>& tags);

/// Of each (n-1)-simplex of the complex its tag, 0 for none; or empty, if `facets` are. Facets
/// that no cell has are left out, and of a facet that is there several times the first one counts;
/// warnings tell of both. Time O(facets log(size(n-1))). Throws InvalidInput for another number of
/// tags.
std::vector<Index> tags_of_facets(const SimplicialComplex& complex, const TaggedSimplices& facets,
                                  std::vector<std::string>& warnings);

/// Of each merged k-cell the tag of its pieces, 0 where they have different ones, with a warning;
/// or empty, if `tags`, one for each k-simplex, are. Simplices that merging has removed, and their
/// tags, are in no k-cell. Throws InvalidInput for another number of tags.
std::vector<Index> merged_tags(const Merging& merging, int k, const std::vector<Index>& tags,
                               std::vector<std::string>& warnings);

} // namespace polydec
