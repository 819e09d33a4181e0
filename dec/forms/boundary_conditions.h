// SPDX-License-Identifier: MIT
#pragma once

#include "complex/relative.h"
#include "dec/forms/side.h"
#include "dec/forms/star.h"

#include <cstdint>
#include <functional>
#include <string>
#include <utility>

namespace polydec {

/// What is known at a facet of the boundary, for forms of any degree and of either side.
enum class BoundaryCondition {
    essential, ///< the values of the form (its trace) are given: Dirichlet for 0-forms
    natural,   ///< what flows through is given, by default nothing: Neumann for 0-forms
    robin,     ///< the trace times a coefficient and what flows through together: impedance
};

/// The conditions on the boundary: one everywhere, or one for each facet, as in
/// BoundaryConditions(BoundaryCondition::natural).essential(hot).robin(cold, 2.5).
struct BoundaryConditions {
    BoundaryConditions(BoundaryCondition on_all = BoundaryCondition::essential,
                       std::vector<BoundaryCondition> on_each = {},
                       std::vector<double> of_robin = {}, std::vector<bool> vertices = {})
        : everywhere(on_all),
          facets(std::move(on_each)),
          coefficients(std::move(of_robin)),
          fixed_vertices(std::move(vertices)) {}

    /// The same with another condition on the marked ones of all (n-1)-cells.
    BoundaryConditions essential(const std::vector<bool>& marks) const;
    BoundaryConditions robin(const std::vector<bool>& marks, double coefficient) const;

    BoundaryCondition everywhere = BoundaryCondition::essential;
    /// Empty, or one for each (n-1)-cell; those with other than one coface do not matter.
    std::vector<BoundaryCondition> facets = {};
    /// Of Robin's condition: one for all facets, or one for each; positive, units 1 / length.
    std::vector<double> coefficients = {};
    /// Empty, or one mark for each 0-cell, inside or on the boundary: where the values of a primal
    /// 0-form are given besides, as on an electrode. Other forms cannot have it.
    std::vector<bool> fixed_vertices = {};

    BoundaryCondition at(Index facet) const { return facets.empty() ? everywhere : facets[facet]; }
};

/// What holds where nothing is done about the boundary: natural everywhere for primal forms; for
/// dual forms essential with values 0, because their derivative leaves out what lies on the
/// boundary. So primal 0-forms have Neumann's condition by themselves, dual ones Dirichlet's.
BoundaryConditions built_in_conditions(Side side);

/// The coefficients of Robin's condition on the facets of the boundary that have it, 0 elsewhere:
/// size(n-1). Throws InvalidInput, naming the facet, where none is given or one that is not
/// positive and finite, and if there are conditions but not one for each facet.
Vector robin_coefficients(const CellComplex& complex, const BoundaryConditions& conditions);

/// Throws InvalidInput, naming what cannot have it, if a facet of the boundary has Robin's
/// condition.
void refuse_robin(const CellComplex& complex, const BoundaryConditions& conditions,
                  const char* what);

/// The conditions with essential and natural exchanged, and others as they are: those of the star
/// of a form, which takes values at the boundary to what flows through it.
BoundaryConditions exchanged(BoundaryConditions conditions);

/// Whether what is known on the boundary can be other than 0.
struct BoundaryData {
    bool values = false;
    bool flow = false;
};

/// What conditions mean for forms of this degree, in words: for 0-forms "values 0 on the boundary
/// (Dirichlet)" or "no flow through the boundary (Neumann)", for n-forms the same of their density,
/// in between "tangential part 0 on the boundary" or "normal part 0 on the boundary"; of mixed ones
/// all with the numbers of facets; Robin's with "flow given" or "0"; "no boundary" where there is
/// none. Throws InvalidInput if there are conditions but not one for each facet.
std::string in_words(const BoundaryConditions& conditions, const CellComplex& complex, int degree,
                     const BoundaryData& data = {});

/// The same of so many facets of a boundary, of which so many are essential and so many Robin's, of
/// forms on cells of dimension n.
std::string in_words(std::int64_t facets, std::int64_t essential, int degree, int n,
                     const BoundaryData& data = {}, std::int64_t robin = 0);

/// Mixed conditions: essential where the predicate holds of a facet's site, natural elsewhere.
/// sites has a row of coordinates for each (n-1)-cell, e.g. their circumcenters (cell_centers).
BoundaryConditions essential_where(const Points& sites,
                                   const std::function<bool(const Vector& site)>& predicate);

/// Throws InvalidInput, with the number of boundary facets, where a mesh has a boundary but these
/// conditions give values on none of it, nor at a vertex; `what` says who gave them.
void require_essential(const CellComplex& complex, const BoundaryConditions& conditions,
                       const std::string& what);

/// Conditions with Robin's in place of the natural one.
BoundaryConditions robin_elsewhere(BoundaryConditions conditions, double coefficient);

/// The cells on which an essential condition fixes primal forms: essential boundary facets and all
/// their faces, in every degree. Relative to these cells a complex carries the forms that vanish
/// there; relative_complex with none of them is the absolute one, natural everywhere.
/// Throws InvalidInput if there are conditions but not one for each facet, or fixed vertices.
CellMarks essential_cells(const CellComplex& complex, const BoundaryConditions& conditions);

/// The same for forms of one side and degree: for dual forms the conditions are exchanged first,
/// and fixed vertices are among the cells for primal 0-forms. Throws InvalidInput for other forms
/// with these, and for another number of marks.
CellMarks essential_cells(const CellComplex& complex, const BoundaryConditions& conditions,
                          Side side, int degree);

/// The volumes of the cells of a relative complex, so that every operator that takes a complex and
/// its volumes acts on forms that vanish on the dropped cells. Errors name cells by their numbers
/// in the whole complex.
CellVolumes relative_volumes(const RelativeComplex& relative, const CellVolumes& volumes);

/// The same for stars: of those that are no diagonal the rows and columns of the cells that are
/// kept.
HodgeStars relative_stars(const RelativeComplex& relative, const HodgeStars& stars);

/// What boundary data add to the derivative of a dual j-form: dual_derivative(j) w + B g is the
/// derivative with the part of the duals' boundaries that lies on the boundary of the domain. With
/// k = n-j-1, B is size(k) x size(k); g has the integral of the form over the dual within the
/// boundary of every k-cell s on it (for j = 0 the value at the facet's circumcenter); values at
/// other cells do not matter. For j > 0 that dual is oriented such that s followed by it is
/// oriented as the boundary is by the outward normal.
SparseMatrix dual_boundary_derivative(const CellComplex& complex, int j);

} // namespace polydec
