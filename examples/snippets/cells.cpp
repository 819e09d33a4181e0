// SPDX-License-Identifier: MIT
//
// The code on docs/cells.md: a complex, its chains and boundary, homology, relative complexes.
#include <iostream>
#include <polydec.h>

namespace {

polydec::SimplicialComplex two_triangles() {
    polydec::Simplices triangles(2, 3);
    triangles << 0, 1, 2, // a row of corners for each triangle
        1, 3, 2;
    return polydec::SimplicialComplex(triangles);
}

void boundary_of_a_square() {
    const polydec::SimplicialComplex square = two_triangles();
    const polydec::Chain whole{polydec::Side::primal, 2, polydec::Vector::Ones(2)};
    const polydec::Chain rim = polydec::boundary(square, whole);
    for (polydec::Index e = 0; e < square.size(1); ++e)
        std::cout << square.simplices(1).row(e) << ": " << rim.values[e] << '\n';
}

void stokes() {
    const polydec::SimplicialComplex square = two_triangles();
    const polydec::Cochain w{polydec::Side::primal, 1, polydec::Vector::LinSpaced(5, 1, 5)};
    const polydec::Chain whole{polydec::Side::primal, 2, polydec::Vector::Ones(2)};
    const double inside = polydec::pairing(polydec::d(square, w), whole);
    const double around = polydec::pairing(w, polydec::boundary(square, whole));
    std::cout << "<dw, c> = " << inside << ", <w, boundary c> = " << around << '\n';
}

void loops_of_a_torus() {
    const auto torus = polydec::discretize(polydec::torus(24, 12));
    const polydec::SparseMatrix loops = polydec::homology_generators(torus.complex(), 1);
    std::cout << "loops " << loops.cols() << ", with edges";
    for (polydec::Index j = 0; j < loops.cols(); ++j)
        std::cout << ' ' << polydec::Vector(loops.col(j)).cwiseAbs().sum();
    const polydec::SparseMatrix ends = polydec::derivative(torus.complex(), 0).transpose() * loops;
    std::cout << ", boundary " << ends.norm() << '\n';
}

void relative_betti_numbers() {
    const polydec::SimplicialComplex strip(polydec::moebius(24, 2).simplices);
    const auto print = [](const char* name, const polydec::CellComplex& complex) {
        std::cout << name;
        for (const auto b : polydec::betti_numbers(complex))
            std::cout << ' ' << b;
        std::cout << '\n';
    };
    print("absolute:", strip);
    print("relative:", polydec::relative_to_boundary(strip).complex);
    std::cout << "orientable: " << (strip.orientable() ? "yes" : "no") << '\n';
}

} // namespace

int main() {
    boundary_of_a_square();
    stokes();
    loops_of_a_torus();
    relative_betti_numbers();
}
