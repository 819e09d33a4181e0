// SPDX-License-Identifier: MIT
#include "dec/boundary_conditions.h"

#include "base/errors.h"

#include <fmt/format.h>

namespace polydec {

namespace {

using Row = IncidenceMatrix::InnerIterator;

/// With each marked cell also its faces.
void close(const CellComplex& complex, CellMarks& marks) {
    for (int k = complex.dimension(); k > 0; --k)
        for (Index t = 0; t < complex.size(k); ++t)
            for (Row s(complex.coboundary(k - 1), t); marks[k][t] && s; ++s)
                marks[k - 1][s.col()] = true;
}

} // namespace

BoundaryConditions essential_where(const Points& sites,
                                   const std::function<bool(const Vector& site)>& predicate) {
    BoundaryConditions conditions;
    for (Index f = 0; f < sites.rows(); ++f)
        conditions.facets.push_back(predicate(sites.row(f).transpose())
                                        ? BoundaryCondition::essential
                                        : BoundaryCondition::natural);
    return conditions;
}

CellMarks essential_cells(const CellComplex& complex, const BoundaryConditions& conditions) {
    const int n = complex.dimension();
    if (!conditions.facets.empty() &&
        static_cast<Index>(conditions.facets.size()) != complex.size(n - 1))
        throw InvalidInput(fmt::format("{} boundary conditions are given: expected one for each of "
                                       "the {} {}-cells, or one for all",
                                       conditions.facets.size(), complex.size(n - 1), n - 1));
    CellMarks marks;
    for (int k = 0; k <= n; ++k)
        marks.emplace_back(complex.size(k), false);
    for (Index f = 0; f < complex.size(n - 1); ++f)
        marks[n - 1][f] = complex.coface_counts(n - 1)[f] == 1 &&
                          conditions.at(f) == BoundaryCondition::essential;
    close(complex, marks);
    return marks;
}

CellVolumes relative_volumes(const RelativeComplex& relative, const CellVolumes& volumes) {
    std::vector<Vector> primal, dual, terms;
    for (int k = 0; k <= relative.complex.dimension(); ++k) {
        primal.push_back(relative.restrict(k, volumes.primal(k)));
        dual.push_back(relative.restrict(k, volumes.dual(k)));
        terms.push_back(relative.restrict(k, volumes.terms(k)));
    }
    return {std::move(primal), std::move(dual), std::move(terms)};
}

SparseMatrix dual_boundary_derivative(const CellComplex& complex, int j) {
    const int n = complex.dimension(), k = n - j - 1;
    const auto marks = boundary_cells(complex);
    const IncidenceMatrix cofaces = complex.boundary(n);
    SparseMatrix B(complex.size(k), complex.size(k));
    B.reserve(Eigen::VectorXi::Ones(complex.size(k)));
    for (Index s = 0; s < complex.size(k); ++s) {
        if (!marks[k][s])
            continue;
        // the dual of a facet within the boundary is a point, which has no orientation
        const double facet_sign = k == n - 1 ? Row(cofaces, s).value() : 1;
        B.insert(s, s) = (k % 2 == 0 ? 1 : -1) * facet_sign;
    }
    B.makeCompressed();
    return B;
}

} // namespace polydec
