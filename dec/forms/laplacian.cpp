// SPDX-License-Identifier: MIT
#include "dec/forms/laplacian.h"

#include "dec/forms/cochain.h"

namespace polydec {

namespace {

/// The adjoint of d_(k-1), k = 0..n+1; zero at both ends, where no star is inverted.
Operator adjoint_of_derivative(const Cells& cells, int k) {
    const Operator d = Operator::derivative(cells.complex(), k - 1);
    if (k == 0 || k > cells.dimension())
        return Operator::zero(d.cols(), d.rows());
    const HodgeStars& stars = cells.stars();
    return in_input_units(Operator::inverse_star(stars[k - 1]) * d.transposed() *
                              Operator::star(stars[k]),
                          cells.unit(), -2, "the codifferential");
}

} // namespace

Operator codifferential(const Cells& cells, int k) {
    cell_degree(cells.complex(), Side::primal, k); // throws for an invalid degree
    return adjoint_of_derivative(cells, k);
}

Operator dual_codifferential(const Cells& cells, int j) {
    const int k = cell_degree(cells.complex(), Side::dual, j);
    const double sign = k % 2 == 0 ? -1 : 1;
    return sign * adjoint_of_derivative(cells, k + 1).transposed();
}

Operator laplacian(const Cells& cells, int k) {
    const CellComplex& complex = cells.complex();
    cell_degree(complex, Side::primal, k); // throws for an invalid degree
    return adjoint_of_derivative(cells, k + 1) * Operator::derivative(complex, k) +
           Operator::derivative(complex, k - 1) * adjoint_of_derivative(cells, k);
}

Operator dual_laplacian(const Cells& cells, int j) {
    return laplacian(cells, cell_degree(cells.complex(), Side::dual, j)).transposed();
}

Operator symmetric_laplacian(const Cells& cells, int k) {
    const CellComplex& complex = cells.complex();
    cell_degree(complex, Side::primal, k); // throws for an invalid degree
    const HodgeStars& stars = cells.stars();
    // in the unit of the cells: products of stars may leave the range where the result does not
    Operator result = Operator::star(stars[k]) * Operator::derivative(complex, k - 1) *
                      adjoint_of_derivative({complex, stars}, k);
    if (k < complex.dimension()) {
        const Operator d = Operator::derivative(complex, k);
        result = d.transposed() * Operator::star(stars[k + 1]) * d + result;
    }
    return in_input_units(result, cells.unit(), complex.dimension() - 2 * k - 2, "the stiffness");
}

} // namespace polydec
