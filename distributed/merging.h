// SPDX-License-Identifier: MIT
#pragma once

#include "dec/merging/merge.h"
#include "dec/metric/cell_volumes.h"
#include "dec/metric/centers.h"
#include "distributed/local_complex.h"

namespace polydec {

/// The cell whose interior an open simplex lies in.
struct Carrier {
    std::int8_t dimension = 0; ///< that of the simplex if it is a piece, or more
    std::int8_t sign = 1;      ///< of the piece in its cell; 0 if it is none
    std::int32_t owner = 0;    ///< rank of the cell's first piece
    GlobalIndex first = 0;     ///< number of that
};

/// What cells a rank's simplices are merged into. The same carriers, signs and rounds, bit by bit,
/// as merge_cospherical gives for the whole in one process.
struct DistributedMerging {
    std::vector<std::vector<Carrier>> carriers; ///< of every local simplex of degree k: carriers[k]
    CellVolumes
        of_pieces;        ///< right where simplices are complete, with duals between shared centers
    Centers centers = {}; ///< those of the pieces
    int rounds = 0;
    bool is_identity = true;             ///< nothing is merged
    GlobalIndex degenerate_interior = 0; ///< see DegenerateFacets, of all ranks
    GlobalIndex degenerate_boundary = 0;
    GlobalIndex degenerate_branching = 0;

    bool is_first_piece(const LocalComplex& local, int k, Index s) const {
        const Carrier& carrier = carriers[k][s];
        return carrier.dimension == k && carrier.first == local.degree(k).number[s];
    }
};

/// Collective: merges as merge_cospherical does. volumes are those of the local simplices. Throws
/// InvalidInput for a tolerance that is negative or not finite.
DistributedMerging merge_cospherical(const Ranks& ranks, const LocalComplex& local,
                                     const CellVolumes& volumes, const MergeOptions& options = {});

} // namespace polydec
