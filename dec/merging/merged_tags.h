// SPDX-License-Identifier: MIT
#pragma once

#include "complex/merging.h"
#include "complex/simplicial_complex.h"
#include "meshes/mesh.h"

#include <string>
#include <vector>

namespace polydec {

/// For each n-simplex of the complex, the tag of its row in the input; empty if `tags` is empty.
/// Throws InvalidInput for a wrong number of tags.
std::vector<Index> tags_of_cells(const SimplicialComplex& complex, const std::vector<Index>& tags);

/// The facet tags of the complex; empty if `facets` is. Facets with several tags get a joint tag,
/// one per set of groups, which no group uses. Facets of no cell are left out. Both cases give a
/// warning. Time O(facets log(size(n-1))). Throws InvalidInput for a wrong number of tags.
FacetTags tags_of_facets(const SimplicialComplex& complex, const TaggedSimplices& facets,
                         std::vector<std::string>& warnings);

/// For each merged k-cell the tag of its pieces; 0, with a warning, if their tags differ. Empty if
/// `tags` (one per k-simplex) is empty. Simplices removed by merging belong to no k-cell, and their
/// tags are dropped. Throws InvalidInput for a wrong number of tags.
std::vector<Index> merged_tags(const Merging& merging, int k, const std::vector<Index>& tags,
                               std::vector<std::string>& warnings);

} // namespace polydec
