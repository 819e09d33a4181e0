// SPDX-License-Identifier: MIT
//
// A periodic box. Its eigenfunctions have frequencies 2 pi (k, l); (0, 1) has multiplicity four, by
// signs and permutations.
#include <iostream>
#include <numbers>
#include <polydec.h>

int main() {
    const auto box = polydec::periodic(polydec::grid(40, 40),
                                       {polydec::Vector{{1, 0}}, polydec::Vector{{0, 1}}});
    const auto mesh = polydec::discretize(box);
    const auto modes =
        polydec::spectrum({mesh, polydec::Side::primal, 0}, {.count = 5}).eigenvalues;
    std::cout << mesh.complex().size(0) << " vertices, no boundary; eigenvalues over 4 pi^2:";
    for (const double eigenvalue : modes.tail(4))
        std::cout << ' ' << eigenvalue / (4 * std::numbers::pi * std::numbers::pi);
    std::cout << '\n';
}
