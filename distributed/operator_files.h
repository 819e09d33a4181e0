// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/discretize.h"

#include <filesystem>
#include <string>
#include <vector>

namespace polydec {

/// Collective: writes the operators of the merged complex into a folder that is made or replaced as
/// a whole, as PETSc's binary files, for MatLoad and VecLoad: d_k, laplacian_primal_k,
/// laplacian_dual_j as matrices, star_k, volume_k, dual_volume_k as vectors, all with the extension
/// .petsc, in the units of the file. Rows and columns stand in the order of cell numbers, so files
/// are the same for any number of ranks, but for rounding. A Laplacian that would divide by zero is
/// left out: what is given tells why. Throws InvalidInput as AtomicFolder does, IoError if writing
/// fails.
std::vector<std::string> write_operators(const Ranks& ranks, const DistributedMesh& mesh,
                                         const std::filesystem::path& folder);

} // namespace polydec
