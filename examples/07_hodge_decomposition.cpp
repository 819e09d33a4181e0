// SPDX-License-Identifier: MIT
//
// Every 1-form on a torus is the sum of a gradient, a curl and a harmonic form, which circulates
// around the two loops. The three parts are orthogonal. Periods determine the harmonic part: its
// integrals along the generators of the homology.
#include <iostream>
#include <polydec.h>

int main() {
    const auto torus = polydec::discretize(polydec::torus(48, 24));
    const auto& P = torus.complex();

    // a wind around the axis that blows slightly upwards in front
    const auto wind = polydec::de_rham(torus, 1, [](const polydec::Vector& p) {
        return polydec::Vector(Eigen::Vector3d(-p[1], p[0], p[0] > 0 ? 0.5 * p[0] : 0.0));
    });
    const auto parts = polydec::hodge_decomposition({torus, polydec::Side::primal, 1}, wind);

    const auto energy = [&](const polydec::Cochain& form) {
        return polydec::inner_product(torus, form, form);
    };
    std::cout << "energy of the wind " << energy(wind) << " = exact " << energy(parts.exact)
              << " + coexact " << energy(parts.coexact) << " + harmonic " << energy(parts.harmonic)
              << '\n';

    const polydec::SparseMatrix loops = polydec::homology_generators(P, 1);
    std::cout << "Betti number " << loops.cols() << ", periods of the wind's exact part: "
              << ((loops.transpose() * parts.exact.values).cwiseAbs().maxCoeff() < 1e-10 ? "none"
                                                                                         : "some")
              << ", of the harmonic part: "
              << (loops.transpose() * parts.harmonic.values).transpose() << '\n';

    polydec::write_page("hodge_decomposition.html",
                        polydec::draw_page(torus,
                                           {{"wind", wind},
                                            {"exact", parts.exact, "a gradient"},
                                            {"coexact", parts.coexact, "a curl"},
                                            {"harmonic", parts.harmonic, "around the loops"}},
                                           "A wind on a torus, and its three parts"));
}
