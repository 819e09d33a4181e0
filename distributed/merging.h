// SPDX-License-Identifier: MIT
#pragma once

#include "dec/merging/merge.h"
#include "dec/metric/cell_volumes.h"
#include "dec/metric/centers.h"
#include "distributed/local_complex.h"

namespace polydec {

/// The cell whose interior contains an open simplex.
struct Carrier {
    std::int8_t dimension = 0; ///< of the cell; the simplex is a piece if its dimension is the same
    std::int8_t sign = 1;      ///< of the piece in its cell; 0 if it is not a piece
    std::int32_t owner = 0;    ///< rank of the cell's first piece
    GlobalIndex first = 0;     ///< number of that piece
};

/// The merged cells of a rank's simplices. Carriers, signs and rounds are bit by bit as from
/// merge_cospherical for the whole mesh in one process.
struct DistributedMerging {
    std::vector<std::vector<Carrier>> carriers; ///< of every local simplex of degree k: carriers[k]
    CellVolumes of_pieces; ///< valid for complete simplices, with duals between shared centers
    Centers centers = {};  ///< of the pieces
    int rounds = 0;
    bool is_identity = true;             ///< nothing is merged
    GlobalIndex degenerate_interior = 0; ///< see DegenerateFacets, over all ranks
    GlobalIndex degenerate_boundary = 0;
    GlobalIndex degenerate_branching = 0;
    std::vector<bool> degenerate = {}; ///< marks of the facets here

    bool is_first_piece(const LocalComplex& local, int k, Index s) const {
        const Carrier& carrier = carriers[k][s];
        return carrier.dimension == k && carrier.first == local.degree(k).number[s];
    }
};

/// Collective: merges like merge_cospherical. `volumes` belong to the local simplices. Throws
/// InvalidInput for a tolerance that is negative or not finite.
DistributedMerging merge_cospherical(const Ranks& ranks, const LocalComplex& local,
                                     const CellVolumes& volumes, const MergeOptions& options = {});

} // namespace polydec
