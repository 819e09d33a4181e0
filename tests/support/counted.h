// SPDX-License-Identifier: MIT
#pragma once

#include "complex/cell_complex.h"
#include "meshes/mesh.h"

#include <set>
#include <vector>

namespace polydec::test {

/// The sets of k+1 vertices that are faces of a simplex, each ascending: counted without a
/// complex.
std::set<std::vector<Index>> faces(const Mesh& mesh, int k);

/// Sum of the n-volumes, not signed, by determinants of the edges from the first corners.
double total_volume(const Mesh& mesh);

/// The numbers of cells of degrees 0..n.
std::vector<Index> sizes(const CellComplex& complex);

/// n over k; 0 unless 0 <= k <= n.
Index binomial(Index n, int k);

} // namespace polydec::test
