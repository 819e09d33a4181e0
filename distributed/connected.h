// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/local_complex.h"
#include "distributed/petsc.h"
#include "solvers/sources/constrained_system.h"

namespace polydec {

/// Collective: of how many connected components a complex consists.
GlobalIndex component_count(const Ranks& ranks, const LocalComplex& local);

/// Own unknowns that are prescribed, and those that boundary data tie down: see ConstrainedSystem.
struct HeldUnknowns {
    std::vector<bool> fixed, tied;
};

/// FreeComponents over all ranks: the connected components of the graph of a matrix that nothing
/// ties down. Every function is collective; vectors have the own entries.
class SharedComponents {
public:
    SharedComponents(const Ranks& ranks, Mat graph, const HeldUnknowns& held, Vector weights);

    /// Collective: of how many connected components a complex consists.
    GlobalIndex component_count(const Ranks& ranks, const LocalComplex& local);

    /// Own unknowns that are set to zero for the time being: one of each component.
    const std::vector<bool>& grounded() const { return grounded_; }

    GlobalIndex count() const { return count_; }
    Compatibility balance(Vector& b) const;
    void remove_means(Vector& u) const;

private:
    std::vector<double> over_all(std::vector<double> of_parts) const;
    std::vector<double> sums(const Vector& values) const;

    Ranks ranks_;
    std::vector<Index> part_; // of own unknowns: a component's part here, -1 where nothing is free
    std::vector<GlobalIndex> component_; // of parts: number of its first part
    GlobalIndex first_part_ = 0, count_ = 0;
    std::vector<bool> grounded_;
    Vector weights_;
    std::vector<double> weights_of_all_; // of parts: of their components
};

} // namespace polydec
