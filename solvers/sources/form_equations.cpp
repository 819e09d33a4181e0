// SPDX-License-Identifier: MIT
#include "solvers/sources/form_equations.h"

#include "base/checks.h"
#include "dec/boundary/boundary_conditions.h"
#include "dec/forms/cochain.h"
#include "dec/forms/gram.h"

#include <vector>

namespace polydec {

namespace {

double sign(int exponent) {
    return exponent % 2 == 0 ? 1 : -1;
}

/// Maps values of unmarked cells to values of all cells, 0 at marked ones.
SparseMatrix all_but(const std::vector<bool>& marks) {
    std::vector<Index> cells;
    for (std::size_t s = 0; s < marks.size(); ++s)
        if (!marks[s])
            cells.push_back(static_cast<Index>(s));
    return inclusion(cells, static_cast<Index>(marks.size()));
}

/// d_k^T star_(k+1) d_k over the cells where w determines dw: all except cells that are left out
/// and lack data on some face. Stars that are matrices couple these with the free ones. Entries at
/// rounding level are dropped.
SparseMatrix upper_stiffness(const FormSpace& space, int k) {
    const CellComplex& complex = space.cells().complex();
    const HodgeStar star = space.cells().stars()[k + 1];
    const CellMarks &fixed = space.fixed(), &left_out = space.left_out();
    const auto unknown = [&](Index cell) { return left_out[k + 1][cell] && !fixed[k + 1][cell]; };
    SparseMatrix A;
    if (star.is_diagonal()) {
        Vector weights = star.diagonal();
        weights(star.zeros()).setZero();
        for (Index cell = 0; cell < weights.size(); ++cell)
            if (unknown(cell))
                weights[cell] = 0;
        A = gram_of_columns(complex, k, weights);
    } else {
        SparseMatrix M = star.matrix();
        M.prune([&](Eigen::Index row, Eigen::Index column, double) {
            return !unknown(static_cast<Index>(row)) && !unknown(static_cast<Index>(column));
        });
        const SparseMatrix d = derivative(complex, k);
        A = SparseMatrix(SparseMatrix(d.transpose()) * M) * d;
    }
    A.prune(0.0);
    return A;
}

SparseMatrix transpose_of(const SparseMatrix& A) {
    return A.transpose();
}

/// For n-cells left out because their center is on the boundary: maps values at their facets there
/// to the value of the cell, the mean.
SparseMatrix centers_on_the_boundary(const CellComplex& complex, const FormSpace& space) {
    const int n = complex.dimension();
    const CellMarks &fixed = space.fixed(), &left_out = space.left_out();
    std::vector<Eigen::Triplet<double, Index>> entries;
    for (Index t = 0; t < complex.size(n); ++t) {
        if (!left_out[n][t])
            continue;
        std::vector<Index> touched;
        for (const SignedFace& f : complex.incidences(n - 1)[t])
            if (left_out[n - 1][f.face] && !fixed[n - 1][f.face])
                touched.push_back(f.face);
        for (const Index f : touched)
            entries.emplace_back(t, f, 1.0 / static_cast<double>(touched.size()));
    }
    SparseMatrix result(complex.size(n), complex.size(n - 1));
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
}

/// Boundary data of a primal k-form w: w, delta w, and star w and star dw over the duals there.
/// Dual forms are stars of primal ones.
struct PrimalData {
    Vector w, below, star_w, star_dw;
};

PrimalData primal_data(const BoundaryForms& data, const FormEquations& of) {
    const int n = of.dimension, k = of.k;
    const auto values = [&](const Vector& given, int degree, const char* what, double factor) {
        const auto size = degree == k ? of.M.rows() : of.M_below.rows();
        if (given.size() == 0)
            return Vector(Vector::Zero(size));
        check_values(what, given, size);
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

std::vector<bool> marks_of(const CellMarks& marks, int k) {
    return k < 0 ? std::vector<bool>() : marks[k];
}

/// The contribution of data at duals within the boundary to d^T of a k-form over duals.
SparseMatrix boundary_part(const CellComplex& complex, int k) {
    const int n = complex.dimension();
    if (k < 0 || k == n)
        return SparseMatrix(k < 0 ? 0 : complex.size(n), k < 0 ? 0 : complex.size(n));
    return sign(k) * dual_boundary_derivative(complex, n - 1 - k);
}

SparseMatrix or_zeros(const SparseMatrix& matrix, Eigen::Index size) {
    return matrix.size() > 0 ? matrix : SparseMatrix(size, size);
}

/// The cells on facets where dual forms have values; all for primal forms.
std::vector<bool> asked_for(const CellComplex& complex, Side side,
                            const BoundaryConditions& conditions, int k) {
    if (k < 0)
        return {};
    return side == Side::primal ? std::vector<bool>(complex.size(k), true)
                                : essential_cells(complex, conditions)[k];
}

} // namespace

FormEquations::FormEquations(const FormSpace& space)
    : FormEquations(space, space.cells().complex(), space.cells().stars()) {}

FormEquations::FormEquations(const FormSpace& space, const CellComplex& complex,
                             const HodgeStars& stars)
    : side(space.side()),
      dimension(complex.dimension()),
      k(space.cell_degree()),
      left_out(space.left_out()[k]),
      left_out_below(marks_of(space.left_out(), k - 1)),
      given(space.fixed()[k]),
      given_below(marks_of(space.fixed(), k - 1)),
      asked(asked_for(complex, side, space.conditions(), k - 1)),
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
    if (k == dimension)
        fix = centers_on_the_boundary(complex, space);
    else
        upper = upper_stiffness(space, k);
    if (k == dimension - 1)
        load = transpose_of(derivative(complex, k)) * centers_on_the_boundary(complex, space);
}

SparseMatrix FormEquations::kept() const {
    return all_but(left_out);
}

SparseMatrix FormEquations::kept_below() const {
    return all_but(left_out_below);
}

namespace {

/// Sets values to 0 elsewhere.
void keep(const std::vector<bool>& marked, Vector& values) {
    for (Index i = 0; i < values.size(); ++i)
        if (!marked[i])
            values[i] = 0;
}

/// Adds A x to a sum, and its magnitude to the terms.
void add(Vector& sum, Vector& terms, double sign_of, const SparseMatrix& A, const Vector& x) {
    if (x.isZero(0))
        return;
    sum += sign_of * (A * x);
    terms += A.cwiseAbs() * x.cwiseAbs();
}

} // namespace

BoundaryLoads FormEquations::loads(const BoundaryForms& data) const {
    PrimalData known = primal_data(data, *this);
    auto& [w, below, star_w, star_dw] = known;
    keep(asked, star_w);
    BoundaryLoads result;
    result.b_terms = result.b = Vector::Zero(M.rows());
    result.g_terms = result.g = Vector::Zero(M_below.rows());
    add(result.b, result.b_terms, 1, B, star_dw);
    add(result.b, result.b_terms, -1, load, star_dw);
    add(result.g, result.g_terms, 1, B_below, star_w);
    add(result.g, result.g_terms, -1, robin_below, below);
    keep(given, w);
    if (fix.nonZeros() > 0)
        w += (fix * star_w).cwiseQuotient(M.diagonal());
    keep(given_below, below);
    result.w = std::move(w);
    result.below = std::move(below);
    return result;
}

BoundaryLoads FormEquations::loads_of_free_values(const BoundaryForms& data) const {
    BoundaryLoads result = loads(data);
    auto& [w, below, b, g, b_terms, g_terms] = result;
    add(b, b_terms, -1, upper, w);
    add(b, b_terms, -1, robin, w);
    add(b, b_terms, -1, transpose_of(down), below);
    add(g, g_terms, 1, M_below, below);
    add(g, g_terms, 1, robin_below, below);
    add(g, g_terms, -1, down, w);
    return result;
}

} // namespace polydec
