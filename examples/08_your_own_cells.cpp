// SPDX-License-Identifier: MIT
//
// A complex is a sequence of signed incidence matrices, so cells may have any shape. This example
// builds a torus of n x n unit squares by hand: vertices, edges along x and y, squares, and the
// volumes of cells and duals, all equal to 1. Everything else works as on a mesh.
#include <iostream>
#include <polydec.h>
#include <vector>

namespace {

polydec::CellComplex periodic_squares(polydec::Index n) {
    const auto at = [n](polydec::Index i, polydec::Index j) { return (i % n) * n + j % n; };
    const polydec::Index squares = n * n;
    polydec::IncidenceMatrix d0(2 * squares, squares), d1(squares, 2 * squares);
    for (polydec::Index i = 0; i < n; ++i)
        for (polydec::Index j = 0; j < n; ++j) {
            const polydec::Index s = at(i, j), right = at(i + 1, j), above = at(i, j + 1);
            const polydec::Index y = squares; // edges along y follow edges along x
            d0.insert(s, s) = d0.insert(y + s, s) = -1;
            d0.insert(s, right) = d0.insert(y + s, above) = 1;
            // around the square: along x, up, back, down
            d1.insert(s, s) = d1.insert(s, y + right) = 1;
            d1.insert(s, above) = d1.insert(s, y + s) = -1;
        }
    return polydec::CellComplex({d0, d1}); // checks that d d = 0
}

} // namespace

int main() {
    const polydec::CellComplex torus = periodic_squares(16);
    std::vector<polydec::Vector> ones;
    for (int k = 0; k <= 2; ++k)
        ones.push_back(polydec::Vector::Ones(torus.size(k)));
    const polydec::Cells cells(torus, polydec::CellVolumes(ones, ones));

    std::cout << "smallest eigenvalues of the Laplacian of 1-forms:";
    const auto modes = polydec::spectrum({cells, polydec::Side::primal, 1}, {.count = 4});
    for (const double value : modes.eigenvalues)
        std::cout << ' ' << (std::abs(value) < 1e-12 ? 0.0 : value);
    // two harmonic forms, then 4 sin^2(pi/16) with multiplicity eight
    std::cout << "\nharmonic 1-forms: "
              << polydec::harmonic_forms({cells, polydec::Side::primal, 1}).cols() << '\n';

    const polydec::Cochain heat{polydec::Side::primal, 0, polydec::Vector::Unit(torus.size(0), 0)};
    const polydec::PoissonSolver solver({cells, polydec::Side::primal, 0}); // makes the mean 0
    std::cout << "above the mean at the source: " << solver.solve(heat).form.values[0] << '\n';
}
