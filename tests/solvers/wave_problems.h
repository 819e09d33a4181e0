// SPDX-License-Identifier: MIT
#pragma once

#include "dec/forms/boundary_conditions.h"
#include "tests/solvers/smooth_waves.h"

namespace polydec::test {

/// Where in the boundary of the unit cube a form is given: everywhere, nowhere, or on the left,
/// with Robin's condition at the other facets or without.
enum class Where { essential, natural, mixed, robin };

constexpr Where everywhere[] = {Where::essential, Where::natural, Where::mixed, Where::robin};

BoundaryConditions conditions_of(const Discretization& mesh, Where where);

/// The smooth form among discrete ones. Where stars are matrices a dual form is what they make of
/// a primal one.
Cochain exact_form(const Discretization& mesh, Side side, const WaveForm& wave);

/// Norm in the inner product of the form's side, but of cells without dual.
double size_of(const Discretization& mesh, const Cochain& form);

/// The conditions' data for the smooth form; of Robin's, the trace's part is added by its star.
BoundaryForms data_of(const Discretization& mesh, Side side, const WaveForm& wave, Where where);

} // namespace polydec::test
