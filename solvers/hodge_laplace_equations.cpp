// SPDX-License-Identifier: MIT
#include "solvers/hodge_laplace_equations.h"

#include "base/checks.h"
#include "base/errors.h"
#include "dec/forms/boundary_conditions.h"
#include "dec/forms/cochain.h"
#include "dec/forms/derivative.h"

#include <fmt/format.h>

#include <vector>

namespace polydec {

namespace {

double sign(int exponent) {
    return exponent % 2 == 0 ? 1 : -1;
}

SparseMatrix kept_cells(const RelativeComplex& relative, int k) {
    return inclusion(relative.cells[k], relative.whole_sizes[k]);
}

/// The k-cells over which dw follows from w: the kept ones and those with data on all faces. Stars
/// that are matrices couple both.
SparseMatrix with_derivative(const RelativeComplex& relative, const CellMarks& fixed, int k) {
    std::vector<bool> known = fixed[k];
    for (const Index cell : relative.cells[k])
        known[cell] = true;
    std::vector<Index> cells;
    for (Index cell = 0; cell < relative.whole_sizes[k]; ++cell)
        if (known[cell])
            cells.push_back(cell);
    return inclusion(cells, relative.whole_sizes[k]);
}

SparseMatrix transpose_of(const SparseMatrix& A) {
    return A.transpose();
}

/// Where the center of an n-cell lies on the boundary and the cell is left out for it: from values
/// at facets to that of the cell.
SparseMatrix centers_on_the_boundary(const CellComplex& complex, const RelativeComplex& relative,
                                     const CellMarks& fixed) {
    const int n = complex.dimension();
    const auto left_out = [&](int k) {
        std::vector<bool> marks(complex.size(k), true);
        for (const Index cell : relative.cells[k])
            marks[cell] = false;
        return marks;
    };
    const auto cells = left_out(n), facets = left_out(n - 1);
    std::vector<Eigen::Triplet<double, Index>> entries;
    for (Index t = 0; t < complex.size(n); ++t) {
        if (!cells[t])
            continue;
        std::vector<Index> touched;
        for (const SignedFace& f : complex.incidences(n - 1)[t])
            if (facets[f.face] && !fixed[n - 1][f.face])
                touched.push_back(f.face);
        for (const Index f : touched)
            entries.emplace_back(t, f, 1.0 / static_cast<double>(touched.size()));
    }
    SparseMatrix result(complex.size(n), complex.size(n - 1));
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}

/// What is known of a primal k-form w on the boundary: w, delta w, and over the duals there star w
/// and star dw. Dual forms are stars of primal ones.
struct PrimalData {
    Vector w, below, star_w, star_dw;
};

PrimalData primal_data(const BoundaryForms& data, const HodgeLaplaceEquations& of) {
    const int n = of.dimension, k = of.k;
    const auto values = [&](const Vector& given, int degree, const char* what, double factor) {
        const auto size = degree == k ? of.M.rows() : of.M_below.rows();
        if (given.size() == 0)
            return Vector(Vector::Zero(size));
        check_as_many(what, given.size(), size);
        if (!given.allFinite())
            throw InvalidInput(fmt::format("{} are not finite", what));
        return Vector(factor * given);
    };
    constexpr auto trace = "boundary values of the form",
                   below = "boundary values of the codifferential",
                   flow = "boundary values of the star of the form",
                   derivative_flow = "boundary values of the star of the derivative";
    if (of.side == Side::primal)
        return {values(data.values, k, trace, 1), values(data.codifferential, k - 1, below, 1),
                values(data.flow, k - 1, flow, 1),
                values(data.derivative_flow, k, derivative_flow, 1)};
    return {values(data.flow, k, flow, sign(k * (n - k))),
            values(data.derivative_flow, k - 1, derivative_flow, sign(k + (k - 1) * (n - k + 1))),
            values(data.values, k - 1, trace, 1),
            values(data.codifferential, k, below, sign(k + 1))};
}

Vector ones_at(const CellMarks& marks, int k) {
    if (k < 0)
        return {};
    Vector result(static_cast<Index>(marks[k].size()));
    for (Index s = 0; s < result.size(); ++s)
        result[s] = marks[k][s] ? 1 : 0;
    return result;
}

/// What data at the duals within the boundary add to d^T of what a k-form has over the duals.
SparseMatrix boundary_part(const CellComplex& complex, int k) {
    const int n = complex.dimension();
    if (k < 0 || k == n)
        return SparseMatrix(k < 0 ? 0 : complex.size(n), k < 0 ? 0 : complex.size(n));
    return sign(k) * dual_boundary_derivative(complex, n - 1 - k);
}

SparseMatrix or_zeros(const SparseMatrix& matrix, Eigen::Index size) {
    return matrix.size() > 0 ? matrix : SparseMatrix(size, size);
}

/// 1 at the cells on facets where dual forms have values, else 0.
Vector asked_for(const CellComplex& complex, Side side, const BoundaryConditions& conditions,
                 int k) {
    return side == Side::primal ? Vector(Vector::Ones(complex.size(k)))
                                : ones_at(essential_cells(complex, conditions), k);
}

} // namespace

HodgeLaplaceEquations::HodgeLaplaceEquations(const FormSpace& space)
    : HodgeLaplaceEquations(space, space.cells().complex(), space.cells().stars()) {}

HodgeLaplaceEquations::HodgeLaplaceEquations(const FormSpace& space, const CellComplex& complex,
                                             const HodgeStars& stars)
    : side(space.side()),
      dimension(complex.dimension()),
      k(space.cell_degree()),
      kept(kept_cells(space.relative(), k)),
      kept_below(k > 0 ? kept_cells(space.relative(), k - 1) : SparseMatrix(0, 0)),
      given(ones_at(space.fixed(), k)),
      given_below(ones_at(space.fixed(), k - 1)),
      asked(k > 0 ? asked_for(complex, side, space.conditions(), k - 1) : Vector()),
      M(stars[k].matrix()),
      M_below(k > 0 ? stars[k - 1].matrix() : SparseMatrix(0, 0)),
      upper(M.rows(), M.rows()),
      down(transpose_of(derivative(complex, k - 1)) * M),
      B(boundary_part(complex, k)),
      B_below(boundary_part(complex, k - 1)),
      fix(M.rows(), B_below.cols()),
      load(M.rows(), M.rows()),
      robin(or_zeros(space.robin_weights(), M.rows())),
      robin_below(or_zeros(space.robin_layer(), M_below.rows())) {
    const SparseMatrix centers = centers_on_the_boundary(complex, space.relative(), space.fixed());
    if (k == dimension) {
        fix = centers;
        return;
    }
    const SparseMatrix d = derivative(complex, k),
                       above = with_derivative(space.relative(), space.fixed(), k + 1);
    const SparseMatrix free = transpose_of(above) * d;
    upper = transpose_of(free) * SparseMatrix(transpose_of(above) * stars[k + 1].matrix() * above) *
            free;
    if (k == dimension - 1)
        load = transpose_of(d) * centers;
}

BoundaryLoads HodgeLaplaceEquations::loads(const BoundaryForms& data) const {
    PrimalData known = primal_data(data, *this);
    known.star_w = known.star_w.cwiseProduct(asked);
    BoundaryLoads result{
        known.w.cwiseProduct(given), known.below.cwiseProduct(given_below), {}, {}, {}, {}};
    auto& [w, below, b, g, b_terms, g_terms] = result;
    if (fix.nonZeros() > 0)
        w += (fix * known.star_w).cwiseQuotient(M.diagonal());
    b_terms = b = Vector::Zero(M.rows());
    g_terms = g = Vector::Zero(M_below.rows());
    const auto add = [](Vector& sum, Vector& terms, double sign_of, const SparseMatrix& A,
                        const Vector& x) {
        sum += sign_of * (A * x);
        terms += A.cwiseAbs() * x.cwiseAbs();
    };
    add(b, b_terms, 1, B, known.star_dw);
    add(b, b_terms, -1, load, known.star_dw);
    add(b, b_terms, -1, upper, w);
    add(b, b_terms, -1, robin, w);
    add(b, b_terms, -1, SparseMatrix(down.transpose()), below);
    add(g, g_terms, 1, M_below, below);
    add(g, g_terms, 1, robin_below, below);
    add(g, g_terms, -1, down, w);
    add(g, g_terms, 1, B_below, known.star_w);
    add(g, g_terms, -1, robin_below, known.below);
    return result;
}

} // namespace polydec
