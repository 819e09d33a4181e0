// SPDX-License-Identifier: MIT
#pragma once

#include "complex/disjoint_sets.h"
#include "complex/merging.h"

#include <functional>

namespace polydec {

/// Whether the k-simplices f and g are one flat piece across their common (k-1)-face s.
using Straightness = std::function<bool(int k, Index s, Index f, Index g)>;

/// Pieces divided into open blocks: the cells of the merged complex before they are numbered. Every
/// open simplex lies in the interior of one block, its carrier. A simplex is a piece of its carrier
/// if both have the same dimension; otherwise it has been removed.
struct Blocks {
    /// Of simplex s of degree k: carriers[k][s]. The block's first piece stands for its number.
    std::vector<std::vector<Merging::Carrier>> carriers;
    std::vector<std::vector<std::int8_t>> signs; ///< orientation of a piece in its block, or 0
    std::vector<CofaceCounts> active_cofaces;    ///< numbers of cofaces of s that are not removed
    std::vector<std::vector<Index>> twisted;     ///< first pieces of blocks with inconsistent signs
};

/// Simplices of one degree joined across facets, with their orientations relative to each other.
struct JoinedSimplices {
    DisjointSets sets;
    std::vector<Index> clashes; ///< simplices at facets where the orientations disagree

    void join(Index a, Index b, int relative_sign) {
        if (!sets.join(a, b, relative_sign))
            clashes.push_back(a);
    }
};

/// The n-simplices, joined across the removed facets. removed_facets: one entry per (n-1)-simplex;
/// facets without two cofaces stay (on a rank, the others lie elsewhere). Throws InvalidInput for a
/// wrong number of entries.
JoinedSimplices join_tops(const Pieces& complex, const std::vector<bool>& removed_facets);

/// Joins n-simplices across the removed facets. Then, for k = n-1 down to 2, joins k-simplices
/// across a (k-1)-simplex with exactly two active cofaces that are straight across it and have
/// equally many cofaces. A (k-1)-simplex without active coface is removed: it lies inside a larger
/// block. Vertices are never removed. Near-linear in the number of incidences. Throws like
/// join_tops.
Blocks join_blocks(const Pieces& complex, const std::vector<bool>& removed_facets,
                   const Straightness& straight);

/// The same for tops that are joined already.
Blocks join_blocks(const Pieces& complex, const std::vector<bool>& removed_facets,
                   JoinedSimplices tops, const Straightness& straight);

/// A block that is not an open ball, hence not a cell. Its pieces induce inconsistent orientations,
/// or its homology relative to its boundary is not (0, .., 0, 1), or a vertex at it has lost all
/// its edges. If no block is like that, the merged complex has the Betti numbers of the pieces.
struct InadmissibleBlock {
    int dimension;
    Index piece;                   ///< first piece
    std::vector<Index> interfaces; ///< removed simplices of one dimension less that joined it
};
std::vector<InadmissibleBlock> inadmissible_blocks(const Pieces& complex, const Blocks& blocks);

} // namespace polydec
