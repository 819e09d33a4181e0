// SPDX-License-Identifier: MIT
#pragma once

#include "base/types.h"

#include <optional>
#include <string>
#include <vector>

namespace polydec {

/// Simplices of one dimension, each with the number of its physical group or region.
struct TaggedSimplices {
    Simplices simplices = {};     ///< vertex numbers, one row per simplex
    std::vector<Index> tags = {}; ///< one for each
};

/// What a file calls a physical group.
struct GroupName {
    int dimension = -1; ///< of its simplices; -1 where the file does not say
    Index tag = 0;
    std::string name = {};
};

/// Of which cells of the input the simplices of a mesh are parts: polygons and solids are split,
/// other cells are divided or left out. Data by cell are given in the order of the input's cells.
struct InputCells {
    std::vector<Index> of_simplices = {}; ///< numbers from 0; empty: each simplex is one, in order
    Index count = 0;                      ///< of the input's cells, if there are numbers
};

/// What a file or a generator gives: points of R^N and top simplices of one dimension n.
struct Mesh {
    Points points;       ///< one row per vertex, N columns
    Simplices simplices; ///< one row per n-simplex, n+1 columns; order gives orientation
    std::vector<std::string> warnings; ///< what was untidy and how it was handled
    std::vector<Index> tags = {}; ///< of each simplex the number of its physical group or region,
                                  ///< 0 for none; or empty
    /// Facets that have a tag of their own, as the parts of a boundary and interfaces do: some
    /// (n-1)-simplices, in any order.
    TaggedSimplices facet_tags = {};
    std::vector<GroupName> groups = {}; ///< those that have names
    InputCells input_cells = {};

    int ambient_dimension() const { return static_cast<int>(points.cols()); }
    int dimension() const { return static_cast<int>(simplices.cols()) - 1; }
};

/// What the mesh knows of `count` cells by row, tags and numbers of the input's cells, for
/// simplices that are, or are parts of, the cells of these rows.
void follow_rows(Mesh& mesh, const std::vector<Index>& rows, Index count);

/// Takes simplices out, which are marked, with what is known of them; the rows that stay.
std::vector<Index> keep_rows(Mesh& mesh, const std::vector<bool>& left_out);

/// Throws InvalidInput, naming the facet, unless every facet with a tag has n vertices of the mesh,
/// and one tag.
void check_facet_tags(const Mesh& mesh);

/// The tag of the group of this dimension that has this name, or this number in digits, whether or
/// not there is one; none for another word.
std::optional<Index> group_tag(const std::vector<GroupName>& groups, int dimension,
                               const std::string& word);

/// The tags of groups of this dimension, each given by its name or by its number in digits. Throws
/// InvalidInput for another word, with the names there are.
std::vector<Index> group_tags(const std::vector<GroupName>& groups, int dimension,
                              const std::vector<std::string>& words);

} // namespace polydec
