// SPDX-License-Identifier: MIT
#pragma once

#include "complex/cell_complex.h"

namespace polydec {

/// Betti numbers b_0, .., b_n over the field of integers modulo the prime 2^31 - 1. They are the
/// rational ones unless the complex has torsion of that very order.
///
/// The complex is first reduced: a cell that is the only remaining face of another (coreduction),
/// starting from one vertex of each component, leaves together with it, which changes no homology
/// and no other incidence. What is left, usually a handful of cells, is eliminated sparsely.
std::vector<Index> betti_numbers(const CellComplex& complex);

} // namespace polydec
