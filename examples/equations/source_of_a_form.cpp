// SPDX-License-Identifier: MIT
//
// Delta u = f for 1-forms on a torus with two harmonic forms. No u matches the harmonic part of f;
// the solver returns this part.
#include <iostream>
#include <polydec.h>

int main() {
    const auto torus = polydec::discretize(polydec::torus(24, 16));
    const auto f = polydec::de_rham(torus, 1, polydec::circulation_form([](const auto& x) {
                                        return polydec::Vector{{x[1], -x[0], x[2]}};
                                    }));
    const polydec::PoissonSolver solver({torus, polydec::Side::primal, 1});
    const auto found = solver.solve(f);
    const auto left = polydec::laplacian(torus, found.form) + found.removed - f;
    std::cout << solver.harmonic_forms().cols() << " harmonic forms, a share of "
              << polydec::norm(torus, found.removed) / polydec::norm(torus, f)
              << "; solved to 1e-9: "
              << (polydec::norm(torus, left) < 1e-9 * polydec::norm(torus, f) ? "yes" : "no")
              << '\n';
}
