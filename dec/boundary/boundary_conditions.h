// SPDX-License-Identifier: MIT
#pragma once

#include "complex/relative.h"
#include "dec/forms/cochain.h"
#include "dec/stars/star.h"

#include <cstdint>
#include <functional>
#include <string>
#include <utility>

namespace polydec {

/// Condition on a boundary facet, for forms of any degree and side.
enum class BoundaryCondition {
    essential, ///< prescribes values of the form (its trace): Dirichlet for 0-forms
    natural,   ///< prescribes the flux, 0 by default: Neumann for 0-forms
    robin,     ///< prescribes a coefficient times the trace, plus the flux: impedance
};

/// Boundary conditions, uniform or one per facet. Example:
/// BoundaryConditions(BoundaryCondition::natural).essential(hot).robin(cold, 2.5).
struct BoundaryConditions {
    BoundaryConditions(BoundaryCondition on_all = BoundaryCondition::essential,
                       std::vector<BoundaryCondition> on_each = {},
                       std::vector<double> of_robin = {}, std::vector<bool> vertices = {})
        : everywhere(on_all),
          facets(std::move(on_each)),
          coefficients(std::move(of_robin)),
          fixed_vertices(std::move(vertices)) {}

    /// The same with another condition on the marked (n-1)-cells; one mark per (n-1)-cell.
    BoundaryConditions essential(const std::vector<bool>& marks) const;
    BoundaryConditions robin(const std::vector<bool>& marks, double coefficient) const;

    BoundaryCondition everywhere = BoundaryCondition::essential;
    /// Empty, or one per (n-1)-cell; only cells with exactly one coface matter.
    std::vector<BoundaryCondition> facets = {};
    /// Robin coefficients: one for all facets, or one per facet; positive, units 1 / length.
    std::vector<double> coefficients = {};
    /// Empty, or one mark per 0-cell, inside or on the boundary: vertices where values of a primal
    /// 0-form are also prescribed, as on an electrode. Not available for other forms.
    std::vector<bool> fixed_vertices = {};

    BoundaryCondition at(Index facet) const { return facets.empty() ? everywhere : facets[facet]; }
};

/// Default conditions: natural for primal forms; essential with zero values for dual forms, because
/// the dual derivative leaves out the boundary. So primal 0-forms satisfy Neumann's condition and
/// dual 0-forms Dirichlet's.
BoundaryConditions built_in_conditions(Side side);

/// Robin coefficients on the boundary facets with Robin's condition, 0 elsewhere: size(n-1). Throws
/// InvalidInput, naming the facet, if a coefficient is missing, not positive or not finite, and
/// unless conditions are uniform or one per facet.
Vector robin_coefficients(const CellComplex& complex, const BoundaryConditions& conditions);

/// Throws InvalidInput, saying that `what` does not support it, if a boundary facet has Robin's
/// condition.
void refuse_robin(const CellComplex& complex, const BoundaryConditions& conditions,
                  const char* what);

/// The conditions with essential and natural exchanged, the others unchanged: the conditions on the
/// star of a form, since on the boundary the star maps values to fluxes.
BoundaryConditions exchanged(BoundaryConditions conditions);

/// Whether the prescribed boundary values and fluxes can be other than 0.
struct BoundaryData {
    bool values = false;
    bool flow = false;
};

/// How many cells boundary conditions apply to. Ranks add up their numbers.
struct BoundaryCounts {
    std::int64_t facets = 0;               ///< on the boundary
    std::int64_t essential = 0, robin = 0; ///< of these; the others are natural
    std::int64_t fixed_vertices = 0;
};

/// Throws InvalidInput unless conditions are uniform or one per facet.
BoundaryCounts boundary_counts(const CellComplex& complex, const BoundaryConditions& conditions);

/// The conditions in words, for forms of this degree on cells of dimension n. 0-forms: "values 0 on
/// the boundary (Dirichlet)" or "no flow through the boundary (Neumann)"; n-forms: the same for
/// their density; in between: "tangential part 0 on the boundary" or "normal part 0 on the
/// boundary". Mixed conditions: all of them with their numbers of facets. Robin: "flow given" or
/// "0". Without a boundary: "no boundary".
std::string in_words(const BoundaryCounts& on, int degree, int n, const BoundaryData& data = {});

/// Mixed conditions: essential where the predicate holds at a facet's site, natural elsewhere.
/// `sites` has one row of coordinates per (n-1)-cell, e.g. circumcenters (cell_centers). Throws
/// InvalidInput for an empty function.
BoundaryConditions essential_where(const Points& sites,
                                   const std::function<bool(const Vector& site)>& predicate);

/// Data given on the boundary, by their names for messages; empty: not given.
struct NamedData {
    std::string values = {}; ///< on essential facets and at fixed vertices
    std::string flow = {};   ///< through natural and Robin facets
    std::string robin = {};  ///< the coefficients of Robin facets
};

/// Throws InvalidInput, naming the data and the number of facets, if a mesh has a boundary but some
/// of the data apply nowhere.
void require_use(const BoundaryCounts& on, const NamedData& data);

/// The same for data of any equation, on a boundary of so many facets. `expected` names the facets
/// where such data apply.
void require_facets(const std::string& what, bool is_used, std::int64_t facets,
                    const char* expected);

/// The conditions with Robin's in place of natural.
BoundaryConditions robin_elsewhere(BoundaryConditions conditions, double coefficient);

/// Marks the cells on which essential conditions fix forms of one side and degree (by default,
/// primal forms that are no functions): essential boundary facets and all their faces, in every
/// degree. For dual forms the conditions are exchanged first; for primal 0-forms fixed vertices are
/// included. A complex relative to these cells carries the forms that vanish there; without marks,
/// relative_complex is the absolute complex, natural everywhere. Throws InvalidInput for fixed
/// vertices with other forms, for a wrong number of marks, and unless conditions are uniform or one
/// per facet.
CellMarks essential_cells(const CellComplex& complex, const BoundaryConditions& conditions,
                          Side side = Side::primal, int degree = 1);

/// Volumes of the cells of a relative complex. With them, every operator of a complex and its
/// volumes acts on forms that vanish on the dropped cells. Errors name cells by their numbers in
/// the whole complex.
CellVolumes relative_volumes(const RelativeComplex& relative, const CellVolumes& volumes);

/// The same for stars; a star that is a matrix keeps the rows and columns of the kept cells.
HodgeStars relative_stars(const RelativeComplex& relative, const HodgeStars& stars);

/// Adds boundary data to the derivative of a dual j-form: dual_derivative(j) w + B g is the
/// derivative that includes the part of the duals' boundaries on the boundary of the domain. With k
/// = n-j-1, B is size(k) x size(k). For each boundary k-cell s, g has the integral of the form over
/// the dual of s within the boundary (for j = 0 the value at the facet's circumcenter); other
/// entries do not matter. For j > 0 that dual is oriented so that s followed by it has the
/// orientation of the boundary, given by the outward normal.
SparseMatrix dual_boundary_derivative(const CellComplex& complex, int j);

} // namespace polydec
