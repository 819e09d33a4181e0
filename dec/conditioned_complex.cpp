// SPDX-License-Identifier: MIT
#include "dec/conditioned_complex.h"

#include "dec/facets_without_dual.h"

namespace polydec {

namespace {

/// The cells whose duals lie on the boundary: facets without dual that are not left out anyway, the
/// n-cells beside them, and what has such cofaces alone.
CellMarks on_the_boundary(const Discretization& discretization, const CellMarks& left_out) {
    const auto& complex = discretization.complex();
    const int n = complex.dimension();
    CellMarks marks;
    for (int k = 0; k <= n; ++k)
        marks.emplace_back(complex.size(k), false);
    marks[n - 1] = boundary_facets_without_dual(discretization);
    for (Index f = 0; f < complex.size(n - 1); ++f)
        if (left_out[n - 1][f])
            marks[n - 1][f] = false;
    for (Index t = 0; t < complex.size(n); ++t)
        for (IncidenceMatrix::InnerIterator f(complex.coboundary(n - 1), t); f; ++f)
            if (marks[n - 1][f.col()])
                marks[n][t] = true;
    for (int k = n - 2; k >= 0; --k) {
        std::vector<bool> has_other(complex.size(k), false);
        for (Index t = 0; t < complex.size(k + 1); ++t)
            for (IncidenceMatrix::InnerIterator s(complex.coboundary(k), t); s; ++s)
                if (marks[k + 1][t])
                    marks[k][s.col()] = true;
                else
                    has_other[s.col()] = true;
        for (Index s = 0; s < complex.size(k); ++s)
            if (has_other[s] || left_out[k][s])
                marks[k][s] = false;
    }
    return marks;
}

} // namespace

ConditionedComplex conditioned_complex(const Discretization& discretization, Side side,
                                       const BoundaryConditions& conditions) {
    const auto& complex = discretization.complex();
    if (side == Side::primal) {
        auto relative = relative_complex(complex, essential_cells(complex, conditions));
        auto volumes = relative_volumes(relative, discretization.volumes());
        return {std::move(relative), std::move(volumes)};
    }
    const auto left_out = essential_cells(complex, exchanged(conditions));
    auto relative = relative_complex(complex, left_out, on_the_boundary(discretization, left_out));
    auto volumes = relative_volumes(relative, discretization.volumes());
    return {std::move(relative), std::move(volumes)};
}

ConditionedComplex conditioned_complex(const Discretization& discretization, Side side, int degree,
                                       const BoundaryConditions& conditions) {
    const bool densities = side == Side::primal && degree == discretization.dimension();
    return densities ? conditioned_complex(discretization, Side::dual, exchanged(conditions))
                     : conditioned_complex(discretization, side, conditions);
}

} // namespace polydec
