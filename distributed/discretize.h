// SPDX-License-Identifier: MIT
#pragma once

#include "dec/forms/star_kind.h"
#include "distributed/cell_numbers.h"

#include <functional>
#include <string>
#include <string_view>

namespace polydec {

/// A mesh over all ranks, ready for calculus: what each of them has of the Discretization that one
/// process would have.
struct DistributedMesh {
    LocalComplex local; ///< with points in units
    DistributedMerging merged;
    DistributedCells cells;
    MergeOptions options;
    double unit = 1;                        ///< see unit_of_length
    std::vector<std::string> warnings = {}; ///< of the whole, on rank 0
    /// That solvers are to take, see DiscretizeOptions::star: automatic or circumcentric ones.
    StarKind star = StarKind::automatic;

    int dimension() const { return local.dimension(); }
};

/// Collective, for solvers: throws InvalidInput, which says how many cells call for others, unless
/// the stars that mesh.star asks for are circumcentric ones. Several ranks have no others.
void check_stars(const Ranks& ranks, const DistributedMesh& mesh);

/// Collective: complex, volumes and merged cells of a mesh of which each rank has a slice, whose
/// memory is given back as soon as may be. `owners`
/// are those of the slice's vertices. Throws like local_complex and merge_cospherical, and where a
/// cell has no volume. stage, if any, is told what begins.
DistributedMesh discretize(const Ranks& ranks, MeshSlice slice, const std::vector<int>& owners,
                           const MergeOptions& options = {},
                           const std::function<void(std::string_view)>& stage = {});

} // namespace polydec
