// SPDX-License-Identifier: MIT
#pragma once

#include "complex/coreduction.h"

#include <utility>

namespace polydec {

/// Elimination computes modulo this prime, 2^31 - 1: products of residues fit 64 bits.
constexpr std::int64_t elimination_prime = 2147483647;

/// A chain with coefficients modulo the prime: ascending cells.
using ModularChain = std::vector<std::pair<Index, std::int64_t>>;

/// Sparse elimination of what coreduction leaves of the coboundary matrices. Boundaries of cells
/// are reduced by earlier ones with the same last face. The last face of a reduced boundary one
/// degree above is itself a boundary up to earlier cells, and needs no reduction.
class CoreElimination {
public:
    /// Eliminates in every degree; in degree `cycles_of` it keeps the combinations with zero
    /// boundary.
    CoreElimination(const CellComplex& complex, const Coreduction& reduction, int cycles_of = -1);

    /// Rank of d_k on the core; 0 for k = -1 and n.
    Index rank(int k) const { return static_cast<Index>(pivot_columns(k).size()); }

    /// k-cells and (k+1)-cells of the core on which d_k attains its rank; ascending rows.
    const std::vector<Index>& pivot_columns(int k) const { return columns_.at(k + 1); }
    const std::vector<Index>& pivot_rows(int k) const { return rows_.at(k + 1); }

    /// Cycles of the core in degree `cycles_of` that span its homology, b_k in number (for k = 0,
    /// minus the base vertices).
    const std::vector<ModularChain>& cycles() const { return cycles_; }

private:
    void eliminate(const CellComplex& complex, const Coreduction& reduction, int k,
                   bool keep_cycles);

    std::vector<std::vector<Index>> columns_, rows_; // at k + 1: of d_k
    std::vector<ModularChain> cycles_;
};

} // namespace polydec
