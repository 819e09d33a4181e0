// SPDX-License-Identifier: MIT
#pragma once

#include "dec/conditioned_complex.h"

#include <optional>

namespace polydec::python {

/// Cells with their stars, all that most operators and solvers take: those of a mesh, the simplices
/// that were given, those on which forms obey conditions, or cells of one's own.
struct Calculus {
    CellComplex complex;
    HodgeStars stars;
    /// That whose cells they are, which knows more of conditions on the boundary.
    std::optional<Discretization> mesh = {};
};

/// One mark for all facets of the boundary, or one for each (n-1)-cell. Those that are not
/// essential have Robin's condition where their coefficient, if there are any, is not 0.
BoundaryConditions conditions_of(const std::vector<bool>& essential, const Vector& robin = {});

/// The cells on which forms obey conditions.
ConditionedComplex conditioned(const Calculus& of, Side side, int degree,
                               const BoundaryConditions& conditions);

} // namespace polydec::python
