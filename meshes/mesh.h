// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <optional>
#include <string>
#include <vector>

namespace polydec {

/// Simplices of one dimension, each with the tag of its physical group or region.
struct TaggedSimplices {
    Simplices simplices = {};     ///< vertex numbers, one row per simplex
    std::vector<Index> tags = {}; ///< one per simplex
};

/// The name of a physical group.
struct GroupName {
    int dimension = -1; ///< of its simplices; -1 if the file has none
    Index tag = 0;
    std::string name = {};
};

/// A tag of facets that belong to several groups at once.
struct JointTag {
    Index tag = 0;
    std::vector<Index> groups = {}; ///< ascending, two or more
};

/// For each facet of a complex its tag, 0 for none, and the meaning of joint tags.
struct FacetTags {
    std::vector<Index> tags = {}; ///< or empty
    std::vector<JointTag> joint = {};
    std::vector<Index> groups = {}; ///< all with facets before merging and flips, ascending
};

/// The input cell that contains each simplex: polygons and solids are split, other cells are
/// divided or omitted. Data per cell are in the order of the input's cells.
struct InputCells {
    std::vector<Index> of_simplices = {}; ///< numbers from 0; empty: each simplex is one, in order
    Index count = 0;                      ///< number of input cells, if of_simplices is not empty
};

/// A mesh from a file or a generator: points of R^N and top simplices of one dimension n.
struct Mesh {
    Points points;       ///< one row per vertex, N columns
    Simplices simplices; ///< one row per n-simplex, n+1 columns; order gives orientation
    std::vector<std::string> warnings; ///< faults found and their treatment
    std::vector<Index> tags =
        {}; ///< tag of the physical group or region of each simplex, 0 for none; or empty
    /// Facets with their own tags, such as boundary parts and interfaces: some (n-1)-simplices, in
    /// any order.
    TaggedSimplices facet_tags = {};
    std::vector<GroupName> groups = {}; ///< the groups with names
    InputCells input_cells = {};
    int bisections = 0; ///< of the simplex that `refined` has divided most often

    int ambient_dimension() const { return static_cast<int>(points.cols()); }
    int dimension() const { return static_cast<int>(simplices.cols()) - 1; }
};

/// Simplices with this many vertices each, from all their vertices in order.
Simplices simplices_of(const std::vector<Index>& vertices, Eigen::Index width);

/// The input cells of simplices that are cells of these rows, or parts of them.
InputCells followed(const InputCells& cells, const std::vector<Index>& rows, Index count);

/// Transfers the tags and input cell numbers of `count` cells to simplices, which are cells of
/// these rows or parts of them.
void follow_rows(Mesh& mesh, const std::vector<Index>& rows, Index count);

/// Removes the marked simplices with their data; returns the rows that stay.
std::vector<Index> keep_rows(Mesh& mesh, const std::vector<bool>& left_out);

/// Throws InvalidInput, naming the facet, unless every tagged facet has n vertices of the mesh and
/// one tag.
void check_facet_tags(const Mesh& mesh);

/// The tag of the group of this dimension with this name, or the number in digits itself, even if
/// no group has it; none for any other word.
std::optional<Index> group_tag(const std::vector<GroupName>& groups, int dimension,
                               const std::string& word);

/// The tags of groups of this dimension, each given by its name or by its number in digits. Throws
/// InvalidInput for another word, listing the known names.
std::vector<Index> group_tags(const std::vector<GroupName>& groups, int dimension,
                              const std::vector<std::string>& words);

} // namespace polydec
