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

/// A tag of facets that are in several groups at once.
struct JointTag {
    Index tag = 0;
    std::vector<Index> groups = {}; ///< ascending, two or more
};

/// Of each (n-1)-simplex its tag, 0 for none, and what joint tags stand for.
struct FacetTags {
    std::vector<Index> tags = {}; ///< or empty
    std::vector<JointTag> joint = {};
};

/// Those of the complex; empty, if `facets` are. A facet that is there with several tags has a
/// joint one, which no other has. Facets that no cell has are left out; warnings tell of both. Time
/// O(facets log(size(n-1))). Throws InvalidInput for another number of tags.
FacetTags tags_of_facets(const SimplicialComplex& complex, const TaggedSimplices& facets,
                         std::vector<std::string>& warnings);

/// Of each merged k-cell the tag of its pieces, 0 where they have different ones, with a warning;
/// or empty, if `tags`, one for each k-simplex, are. Simplices that merging has removed, and their
/// tags, are in no k-cell. Throws InvalidInput for another number of tags.
std::vector<Index> merged_tags(const Merging& merging, int k, const std::vector<Index>& tags,
                               std::vector<std::string>& warnings);

} // namespace polydec
