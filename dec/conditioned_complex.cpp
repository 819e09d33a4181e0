// SPDX-License-Identifier: MIT
#include "dec/conditioned_complex.h"

#include "base/errors.h"
#include "dec/forms/cochain.h"
#include "dec/forms/operator.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace polydec {

namespace {

/// The cells whose duals lie on the boundary: facets without dual that are not left out anyway, the
/// n-cells beside them, and what has such cofaces alone.
CellMarks on_the_boundary(const CellComplex& complex, std::vector<bool> without_dual,
                          const CellMarks& left_out) {
    const int n = complex.dimension();
    CellMarks marks;
    for (int k = 0; k <= n; ++k)
        marks.emplace_back(complex.size(k), false);
    marks[n - 1] = std::move(without_dual);
    for (Index f = 0; f < complex.size(n - 1); ++f)
        if (left_out[n - 1][f])
            marks[n - 1][f] = false;
    if (std::find(marks[n - 1].begin(), marks[n - 1].end(), true) == marks[n - 1].end())
        return marks;
    for (Index t = 0; t < complex.size(n); ++t)
        for (const SignedFace& f : complex.incidences(n - 1)[t])
            if (marks[n - 1][f.face])
                marks[n][t] = true;
    for (int k = n - 2; k >= 0; --k) {
        std::vector<bool> has_other(complex.size(k), false);
        for (Index t = 0; t < complex.size(k + 1); ++t)
            for (const SignedFace& s : complex.incidences(k)[t])
                if (marks[k + 1][t])
                    marks[k][s.face] = true;
                else
                    has_other[s.face] = true;
        for (Index s = 0; s < complex.size(k); ++s)
            if (has_other[s] || left_out[k][s])
                marks[k][s] = false;
    }
    return marks;
}

} // namespace

void refuse_branching(const Cells& cells, Side side, int degree) {
    if (side == Side::primal || degree > 0)
        return;
    const int facets = cells.dimension() - 1;
    const auto& counts = cells.complex().coface_counts(facets);
    for (Index f = 0; f < cells.complex().size(facets); ++f)
        if (counts[f] > 2)
            throw InvalidInput(fmt::format("{} cells meet at {}, so what flows through it is no "
                                           "difference of two values of a dual 0-form: take "
                                           "primal 0-forms",
                                           counts[f], cells.name(facets, f)),
                               cells.place(facets, f));
}

namespace {

/// The facets without dual at which values are given.
std::vector<bool> but_for_robin(std::vector<bool> facets, const BoundaryConditions& conditions) {
    for (std::size_t f = 0; f < facets.size(); ++f)
        if (conditions.at(static_cast<Index>(f)) == BoundaryCondition::robin)
            facets[f] = false;
    return facets;
}

/// Rows and columns of the kept cells.
SparseMatrix kept_part(const RelativeComplex& relative, int k, const SparseMatrix& of_all) {
    const SparseMatrix P = inclusion(relative.cells[k], relative.whole_sizes[k]);
    return P.transpose() * of_all * P;
}

RobinComplex with(RobinParts parts, ConditionedComplex space, int k) {
    auto& [relative, stars, unit] = space;
    if (parts.layer.size() > 0)
        stars = stars.with(k - 1, stars[k - 1].matrix() + kept_part(relative, k - 1, parts.layer));
    SparseMatrix weights;
    if (parts.weights.size() > 0)
        weights = kept_part(relative, k, parts.weights);
    return {std::move(space), std::move(weights), std::move(parts)};
}

} // namespace

ConditionedComplex conditioned_but_for_robin(const Cells& cells, Side side, int degree,
                                             const BoundaryConditions& conditions) {
    const CellComplex& complex = cells.complex();
    cell_degree(complex, side, degree); // which there must be
    const bool densities = side == Side::primal && degree == complex.dimension();
    refuse_branching(cells, side, degree);
    const auto left_out = essential_cells(complex, conditions, side, degree);
    auto relative =
        side == Side::dual || densities
            ? relative_complex(
                  complex, left_out,
                  on_the_boundary(complex,
                                  but_for_robin(cells.boundary_facets_without_dual(), conditions),
                                  left_out))
            : relative_complex(complex, left_out);
    auto restricted = relative_stars(relative, cells.stars());
    return {std::move(relative), std::move(restricted), cells.unit()};
}

ConditionedComplex conditioned_complex(const Cells& cells, Side side, int degree,
                                       const BoundaryConditions& conditions) {
    refuse_robin(cells.complex(), conditions, "this problem");
    return conditioned_but_for_robin(cells, side, degree, conditions);
}

BoundaryConditions in_unit_of(const Cells& cells, BoundaryConditions conditions) {
    for (double& coefficient : conditions.coefficients)
        coefficient *= cells.unit();
    return conditions;
}

RobinParts robin_parts(const Cells& cells, Side side, int degree,
                       const BoundaryConditions& conditions) {
    const Vector robin = robin_coefficients(cells.complex(), in_unit_of(cells, conditions));
    const int k = cell_degree(cells.complex(), side, degree);
    RobinParts parts;
    if (!robin.isZero(0) && side == Side::primal && k < cells.dimension())
        parts.weights = cells.boundary_star(k, robin);
    if (!robin.isZero(0) && side == Side::dual && k > 0)
        parts.layer = cells.boundary_star(
            k - 1, (robin.array() > 0).select(robin.cwiseInverse(), 0.0 * robin));
    return parts;
}

RobinComplex with_robin(const Cells& cells, Side side, int degree,
                        const BoundaryConditions& conditions) {
    return with(robin_parts(cells, side, degree, conditions),
                conditioned_but_for_robin(cells, side, degree, conditions),
                cell_degree(cells.complex(), side, degree));
}

} // namespace polydec
