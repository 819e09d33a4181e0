// SPDX-License-Identifier: MIT
#pragma once

#include "complex/cell_complex.h"

namespace polydec {

/// Betti numbers b_0, .., b_n over the integers modulo the prime 2^31 - 1. They are the rational
/// Betti numbers unless the complex has torsion of exactly that order.
///
/// Coreduction simplifies the complex first; sparse elimination treats the rest. For homology
/// relative to a set of cells, pass the relative complex.
std::vector<Index> betti_numbers(const CellComplex& complex);

/// A basis of the k-th homology over the rationals: b_k columns of size(k) integers, cycles of
/// which no nonzero combination is a boundary. G^T w are the periods of a closed k-form w. On a
/// surface the columns for k = 1 are loops through a spanning tree, one per edge outside tree and
/// cotree; in general the cycles of the core are carried back through the coreduction.
/// Throws InvalidInput if there is no such degree.
SparseMatrix homology_generators(const CellComplex& complex, int k);

/// Cells on which d_k is invertible, rank(d_k) of each degree. For k = 0: all vertices but one per
/// component, and the edges of a spanning forest.
struct RegularMinor {
    std::vector<Index> columns; ///< k-cells, ascending: their coboundaries are independent
    std::vector<Index> rows;    ///< (k+1)-cells, ascending: their boundaries are independent
};

/// A largest invertible minor of d_k. It allows solving normal equations of d_k without knowledge
/// of their kernel. Throws InvalidInput if there is no such degree; for k = n it is empty.
RegularMinor regular_minor(const CellComplex& complex, int k);

} // namespace polydec
