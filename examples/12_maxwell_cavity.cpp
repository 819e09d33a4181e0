// SPDX-License-Identifier: MIT
//
// Standing waves of the electric field in a box with conducting walls: curl curl E = lambda E with
// E a 1-form that vanishes on the walls. The box is a grid of cubes, each split into six tetrahedra
// of one circumsphere; these are merged, and so are their faces, down to the 12 edges and 6 squares
// of a cube. The exact eigenvalues of the unit cube are pi^2 (i^2 + j^2 + k^2) for natural numbers
// of which at most one is 0: twice if none is, else once.
#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <numbers>
#include <polydec.h>

int main() {
    const auto box = polydec::discretize(polydec::kuhn(3, 8));
    const auto cavity = polydec::relative_to_boundary(box.complex());
    const auto volumes = polydec::relative_volumes(cavity, box.volumes());
    const auto modes =
        polydec::coexact_spectrum(cavity.complex, volumes, {.degree = 1, .count = 17});

    std::cout << "eigenvalues / pi^2, to tell from 2, 3, 5 and 6:" << std::fixed
              << std::setprecision(3);
    for (const double lambda : modes.eigenvalues)
        std::cout << ' ' << lambda / (std::numbers::pi * std::numbers::pi);
    std::cout << '\n'
              << (modes.certificate.complete ? "proved: none is missing" : "not proved") << '\n';

    // how strong the field of the six modes near 5 pi^2 is together, which does not depend on how
    // they are told from each other; a corner is cut out
    polydec::Vector energy = polydec::Vector::Zero(box.complex().size(3));
    for (polydec::Index mode = 5; mode < 11; ++mode) {
        const polydec::Cochain E{polydec::Side::primal, 1, cavity.extend(1, modes.modes.col(mode))};
        energy += polydec::sharp_pd(box, E).rowwise().squaredNorm();
    }
    const auto solid = polydec::kept_faces(
        box, [](const auto& x) { return x[0] < 0.5 || x[1] > 0.5 || x[2] < 0.5; }, energy);
    std::ofstream("maxwell_cavity.svg") << polydec::to_svg(polydec::draw_solid(
        solid, {.eye = Eigen::Vector3d(1.1, -1.5, 1), .title = "Energy of six standing waves"}));

    polydec::write_page("maxwell_cavity.html",
                        polydec::draw_page(box,
                                           {{"energy",
                                             {polydec::Side::dual, 0, energy},
                                             "|E|^2, the sum over six modes of norm 1"}},
                                           "Energy of six standing waves"));
}
