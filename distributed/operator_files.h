// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/discretize.h"

#include <filesystem>
#include <string>
#include <vector>

namespace polydec {

/// Collective: writes the operators of the merged complex into a folder that is made or replaced as
/// a whole, as PETSc binary files, for MatLoad and VecLoad: d_k, laplacian_primal_k,
/// laplacian_dual_j as matrices, star_k, volume_k, dual_volume_k as vectors, all with the extension
/// .petsc, in the units of the file. Rows and columns are in the order of cell numbers, so files
/// are the same for any number of ranks, up to rounding. Omits a Laplacian that would divide by
/// zero; the result lists the reasons. Throws InvalidInput like AtomicFolder, IoError if writing
/// fails.
std::vector<std::string> write_operators(const Ranks& ranks, const DistributedMesh& mesh,
                                         const std::filesystem::path& folder);

} // namespace polydec
