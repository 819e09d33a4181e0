// SPDX-License-Identifier: MIT
//
// Standing waves of the electric field in a box with conducting walls: curl curl E = lambda E, with
// a 1-form E that vanishes on the walls. The box is a grid of cubes, each split into six tetrahedra
// with a common circumsphere. Merging joins them and their faces, down to the 12 edges and 6
// squares of a cube. The exact eigenvalues of the unit cube are pi^2 (i^2 + j^2 + k^2) for integers
// i, j, k >= 0. At most one of i, j, k is 0; the multiplicity is two if none is, else one.
#include <cmath>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <numbers>
#include <polydec.h>

namespace {
constexpr double pi = std::numbers::pi;
}

int main() {
    const auto box = polydec::discretize(polydec::kuhn(3, 8));
    const polydec::FormSpace cavity(box, polydec::Side::primal, 1,
                                    {polydec::BoundaryCondition::essential});
    const auto modes = polydec::coexact_spectrum(cavity, {.count = 17});

    std::cout << "eigenvalues / pi^2, to tell from 2, 3, 5 and 6:" << std::fixed
              << std::setprecision(3);
    for (const double lambda : modes.eigenvalues)
        std::cout << ' ' << lambda / (pi * pi);
    std::cout << '\n'
              << (modes.certificate.complete ? "proved: none is missing" : "not proved") << '\n';

    // Six modes with eigenvalues near 5 pi^2 are some basis of this eigenspace. Combines them to
    // the wave sin(2 pi x) sin(pi y) along z; the picture has a corner cut out.
    const auto wave = [](const auto& p) -> polydec::Vector {
        return Eigen::Vector3d(0, 0, std::sin(2 * pi * p[0]) * std::sin(pi * p[1]));
    };
    const auto wanted = polydec::de_rham(box, 1, wave).values;
    const auto six = modes.modes.middleCols(5, 6);
    const polydec::Vector mass = polydec::star(box, 1).diagonal();
    const polydec::Vector found = six * (six.transpose() * mass.cwiseProduct(wanted));
    std::cout << "of a wave of 5 pi^2 found: "
              << std::sqrt(found.dot(mass.cwiseProduct(found)) /
                           wanted.dot(mass.cwiseProduct(wanted)))
              << '\n';
    const polydec::Cochain E{polydec::Side::primal, 1, found};
    const polydec::Vector vertical = polydec::sharp_pd(box, E).col(2);
    const auto solid = polydec::kept_faces(
        box, [](const auto& x) { return x[0] < 0.5 || x[1] > 0.5 || x[2] < 0.5; }, vertical);
    std::ofstream("maxwell_cavity.svg") << polydec::to_svg(polydec::draw_solid(
        solid, {.eye = Eigen::Vector3d(1.1, -1.5, 1), .title = "A standing wave: E upwards"}));

    polydec::write_page(
        "maxwell_cavity.html",
        polydec::draw_page(
            box, {{"E_z", {polydec::Side::dual, 0, vertical}, "the electric field upwards"}},
            "A standing wave in a box, of eigenvalue 5 pi^2"));
}
