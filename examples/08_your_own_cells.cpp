// SPDX-License-Identifier: MIT
//
// A complex is its tower of signed incidence matrices, so any cells will do. Here a torus is made
// by hand of n x n unit squares: vertices, then edges along x and y, then squares, and the volumes
// of the cells and of their duals, which all are 1. Everything else works as on a mesh.
#include <iostream>
#include <polydec.h>
#include <vector>

namespace {

using Entry = Eigen::Triplet<std::int8_t, polydec::Index>;

polydec::CellComplex periodic_squares(polydec::Index n) {
    const auto at = [n](polydec::Index i, polydec::Index j) { return (i % n) * n + j % n; };
    const polydec::Index squares = n * n;
    std::vector<Entry> ends, sides;
    for (polydec::Index i = 0; i < n; ++i)
        for (polydec::Index j = 0; j < n; ++j) {
            const polydec::Index x = at(i, j), y = squares + at(i, j); // edges from vertex (i, j)
            ends.insert(ends.end(), {Entry(x, at(i, j), -1), Entry(x, at(i + 1, j), 1),
                                     Entry(y, at(i, j), -1), Entry(y, at(i, j + 1), 1)});
            // around the square: along x, up, back, down
            sides.insert(sides.end(),
                         {Entry(at(i, j), x, 1), Entry(at(i, j), squares + at(i + 1, j), 1),
                          Entry(at(i, j), at(i, j + 1), -1), Entry(at(i, j), y, -1)});
        }
    polydec::IncidenceMatrix d0(2 * squares, squares), d1(squares, 2 * squares);
    d0.setFromTriplets(ends.begin(), ends.end());
    d1.setFromTriplets(sides.begin(), sides.end());
    return polydec::CellComplex({d0, d1}); // checks that d d = 0
}

} // namespace

int main() {
    const polydec::CellComplex torus = periodic_squares(16);
    std::vector<polydec::Vector> ones;
    for (int k = 0; k <= 2; ++k)
        ones.push_back(polydec::Vector::Ones(torus.size(k)));
    const polydec::CellVolumes volumes(ones, ones);

    std::cout << "Betti numbers";
    for (const auto b : polydec::betti_numbers(torus))
        std::cout << ' ' << b;
    std::cout << "\nsmallest eigenvalues of the Laplacian of 1-forms:";
    const auto modes = polydec::spectrum(torus, volumes, {.degree = 1, .count = 4});
    for (const double value : modes.eigenvalues)
        std::cout << ' ' << (std::abs(value) < 1e-12 ? 0.0 : value);
    // two harmonic forms, then 4 sin^2(pi/16), eight times
    std::cout << "\nharmonic 1-forms: "
              << polydec::harmonic_forms(torus, volumes, polydec::Side::primal, 1).cols() << '\n';
}
