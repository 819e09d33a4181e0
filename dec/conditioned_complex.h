// SPDX-License-Identifier: MIT
#pragma once

#include "dec/forms/boundary_conditions.h"
#include "dec/forms/cells.h"

#include <string>
#include <vector>

namespace polydec {

/// Throws InvalidInput, naming the facet, for dual 0-forms where three n-cells or more meet: they
/// have no difference along its dual.
void refuse_branching(const Cells& cells, Side side, int degree);

/// The complex and the stars on which the forms of one side obey homogeneous boundary conditions:
/// what takes a complex and its stars (operators, spectra, heat, Hodge decompositions) acts on
/// these forms there.
struct ConditionedComplex {
    RelativeComplex relative;
    HodgeStars stars; ///< in the unit of the whole
    double unit = 1;  ///< see Cells

    Cells cells() const { return {relative.complex, stars, unit}; }
};

/// Primal forms vanish on the essential facets and their faces, so these are left out. The star
/// takes a dual form's values on the boundary to what flows out of a primal one, so for dual forms
/// the natural facets and their faces are. Of the essential ones those without dual (see
/// boundary_facets_without_dual) are left out with the n-cell beside each and what has no other
/// cofaces: the duals of these cells lie on the boundary, where dual forms are 0.
/// Primal n-forms are the stars of dual 0-forms, which do without the duals of boundary facets.
/// Linear time. Throws InvalidInput if there are no forms of that degree, if there are conditions
/// but not one for each facet, for dual 0-forms where three n-cells meet, naming the facet, and for
/// Robin's condition, of which stars know nothing.
ConditionedComplex conditioned_complex(const Cells& cells, Side side, int degree,
                                       const BoundaryConditions& conditions);

/// The same without what Robin's condition adds to stars and operators: on its facets nothing is
/// left out.
ConditionedComplex conditioned_but_for_robin(const Cells& cells, Side side, int degree,
                                             const BoundaryConditions& conditions);

/// What Robin's condition adds for forms of one side and degree, on k-cells, or on those below:
/// boundary stars, 0 off its facets; 0 x 0 where it adds nothing.
struct RobinParts {
    SparseMatrix weights = {}; ///< of primal forms, to star Delta
    SparseMatrix layer = {}; ///< of dual ones, which it holds back as by a layer, to the star below
};

/// Conditions in the unit of cells: the coefficients of Robin's condition are 1 over lengths of
/// the input.
BoundaryConditions in_unit_of(const Cells& cells, BoundaryConditions conditions);

/// Throws like robin_coefficients and Cells::boundary_star.
RobinParts robin_parts(const Cells& cells, Side side, int degree,
                       const BoundaryConditions& conditions);

/// The conditioned complex with these parts: with a layer the star below is a matrix.
struct RobinComplex {
    ConditionedComplex space;
    SparseMatrix weights; ///< of the kept k-cells; 0 x 0: none
    RobinParts parts;     ///< of all cells
};

/// Throws like conditioned_but_for_robin and robin_parts.
RobinComplex with_robin(const Cells& cells, Side side, int degree,
                        const BoundaryConditions& conditions);

} // namespace polydec
