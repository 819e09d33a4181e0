// SPDX-License-Identifier: MIT
#pragma once

#include "distributed/local_complex.h"
#include "distributed/petsc.h"
#include "solvers/sources/constrained_system.h"

namespace polydec {

/// Collective: the number of connected components of a complex.
GlobalIndex component_count(const Ranks& ranks, const LocalComplex& local);

/// Own unknowns that are prescribed, and own unknowns tied by boundary data: see ConstrainedSystem.
struct HeldUnknowns {
    std::vector<bool> fixed, tied;
};

/// FreeComponents over all ranks: the connected components of a matrix graph that nothing ties
/// down. Every function is collective; vectors have own entries.
class SharedComponents {
public:
    SharedComponents(const Ranks& ranks, Mat graph, const HeldUnknowns& held, Vector weights);

    /// Collective: the number of connected components of a complex.
    GlobalIndex component_count(const Ranks& ranks, const LocalComplex& local);

    /// Own unknowns that are temporarily set to zero: one of each component.
    const std::vector<bool>& grounded() const { return grounded_; }

    GlobalIndex count() const { return count_; }
    Compatibility balance(Vector& b) const;
    void remove_means(Vector& u) const;

private:
    std::vector<double> over_all(std::vector<double> of_parts) const;
    std::vector<double> sums(const Vector& values) const;

    Ranks ranks_;
    std::vector<Index> part_; // of own unknowns: local part of a component, -1 if not free
    std::vector<GlobalIndex> component_; // of parts: number of its first part
    GlobalIndex first_part_ = 0, count_ = 0;
    std::vector<bool> grounded_;
    Vector weights_;
    std::vector<double> weights_of_all_; // of parts: total weight of their components
};

} // namespace polydec
