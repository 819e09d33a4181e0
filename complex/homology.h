// SPDX-License-Identifier: MIT
#pragma once

#include "complex/cell_complex.h"

namespace polydec {

/// Betti numbers b_0, .., b_n over the field of integers modulo the prime 2^31 - 1. They are the
/// rational ones unless the complex has torsion of that very order.
///
/// The complex is first taken apart by coreduction; what is left is eliminated sparsely. For the
/// homology relative to a set of cells hand over the relative complex.
std::vector<Index> betti_numbers(const CellComplex& complex);

/// A basis of the k-th homology over the rationals: b_k columns of size(k) integers, cycles none of
/// whose combinations is a boundary. G^T w are the periods of a closed k-form w. On a surface the
/// columns for k = 1 are the loops that a spanning tree and the edges outside of tree and cotree
/// make; in general the cycles of the core are carried back through the coreduction.
/// Throws InvalidInput if there is no such degree.
SparseMatrix homology_generators(const CellComplex& complex, int k);

/// Cells between which d_k is regular, rank(d_k) of each degree: for k = 0 all vertices but one of
/// each component, and the edges of a spanning forest.
struct RegularMinor {
    std::vector<Index> columns; ///< k-cells, ascending: their coboundaries are independent
    std::vector<Index> rows;    ///< (k+1)-cells, ascending: their boundaries are independent
};

/// A largest regular minor of d_k. With it, normal equations of d_k are solved without knowing
/// their kernel. Throws InvalidInput if there is no such degree; for k = n it is empty.
RegularMinor regular_minor(const CellComplex& complex, int k);

} // namespace polydec
