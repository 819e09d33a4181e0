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

    /// Own unknowns that are temporarily set to zero: one of each component.
    const std::vector<bool>& grounded() const { return grounded_; }

    GlobalIndex count() const { return count_; }
    Compatibility balance(Vector& b) const;
    void remove_means(Vector& u) const { parts_.remove_means(u); }

private:
    Ranks ranks_;
    GlobalIndex count_ = 0;
    std::vector<bool> grounded_;
    FreeComponents parts_; // the local parts of components
};

} // namespace polydec
