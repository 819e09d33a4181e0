// SPDX-License-Identifier: MIT
//
// A complex stores cells and their incidences, but no lengths. Two triangles form a square here.
// They show vertices, edges and faces with their orientations, and the two facts behind the
// calculus: the boundary of a boundary is zero, and d is the transpose of the boundary.
#include <iostream>
#include <polydec.h>

int main() {
    polydec::Simplices triangles(2, 3);
    triangles << 0, 1, 2, // each row holds the corners of a triangle
        1, 3, 2;
    const polydec::SimplicialComplex square(triangles);

    for (int k = 0; k <= square.dimension(); ++k)
        std::cout << square.size(k) << " cells of degree " << k << '\n';

    // edges run from the smaller vertex number to the larger
    std::cout << "edges:";
    for (polydec::Index e = 0; e < square.size(1); ++e)
        std::cout << "  " << square.simplices(1)(e, 0) << '-' << square.simplices(1)(e, 1);
    std::cout << "\nd_1, a row for each triangle:\n"
              << polydec::DenseMatrix(polydec::derivative(square, 1)) << '\n';

    // the boundary of the sum of both triangles is the outline of the square
    const polydec::Chain all{polydec::Side::primal, 2, polydec::Vector::Ones(2)};
    const polydec::Chain outline = polydec::boundary(square, all);
    std::cout << "boundary of both: " << outline.values.transpose() << '\n';
    std::cout << "boundary of the boundary: "
              << polydec::boundary(square, outline).values.transpose() << '\n';

    std::cout << "Euler characteristic " << polydec::euler_characteristic(square)
              << ", Betti numbers";
    for (const auto b : polydec::betti_numbers(square))
        std::cout << ' ' << b;
    std::cout << '\n';
}
