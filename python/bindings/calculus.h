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

/// None: the built-in ones.
using GivenConditions = std::optional<BoundaryConditions>;

/// The cells on which forms obey conditions.
ConditionedComplex conditioned(const Calculus& of, Side side, int degree,
                               const BoundaryConditions& conditions);

} // namespace polydec::python
