// SPDX-License-Identifier: MIT
#pragma once

#include "base/progress.h"
#include "dec/stars/star.h"
#include "distributed/cell_numbers.h"

#include <string>
#include <string_view>

namespace polydec {

/// A mesh over all ranks, ready for calculus: each rank's part of the Discretization of one
/// process.
struct DistributedMesh {
    LocalComplex local; ///< with points in units; if only n coordinates vary, these
    DistributedMerging merged;
    DistributedCells cells;
    MergeOptions options;
    Points places = {};                     ///< of local vertices, in units, all coordinates
    double unit = 1;                        ///< see unit_of_length
    std::vector<std::string> warnings = {}; ///< of the whole mesh, on rank 0
    /// The requested stars for solvers, see DiscretizeOptions::star: automatic or circumcentric.
    StarKind star = StarKind::automatic;

    int dimension() const { return local.dimension(); }
};

/// Collective, for solvers: throws InvalidInput, with the number of cells that need others, unless
/// mesh.star selects circumcentric stars. Several ranks support only these.
void check_stars(const Ranks& ranks, const DistributedMesh& mesh);

/// Own facet f in messages, by its number and its vertices.
std::string facet_name(const DistributedMesh& mesh, Index f);

/// Throws InvalidInput, naming an own facet with more than two cofaces: the difference of a dual
/// 0-form along its dual is undefined.
void check_not_branching(const DistributedMesh& mesh);

/// Collective: complex, volumes and merged cells of a mesh given by slices, which are freed as
/// early as possible. `owners` belong to the slice's vertices. Throws like local_complex and
/// merge_cospherical, and if a cell has no volume. `stage`, if any, is called at the start of each
/// stage.
DistributedMesh discretize(const Ranks& ranks, MeshSlice slice, const std::vector<int>& owners,
                           const MergeOptions& options = {}, const Progress& stage = {});

} // namespace polydec
